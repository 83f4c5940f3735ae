"""The web application: the page's files, and the WebSocket over which it plays."""

from __future__ import annotations

import asyncio
import mimetypes
import time
from pathlib import Path

from starlette.applications import Starlette
from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.routing import Mount, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocket, WebSocketClose

from covey.web.serving.admission import Admission
from covey.web.serving.connection import converse
from covey.web.serving.origin import address_of, is_own_host, is_own_origin

MOST_PAGES = 200
"""At once; the server tells another page to come back later."""

_REQUESTS_PER_SECOND, _REQUESTS_AT_ONCE = 50.0, 200
"""Of one address. A page makes 16 when it is opened, each takes 1 to 3 ms."""

_FOLDER = Path(__file__).parents[1] / "page"
_TRY_AGAIN_LATER = 1013

_HEADERS = {
    # Nothing is loaded from other servers, even if a bug or a record asks for it.
    "content-security-policy": (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
        "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cache-control": "no-cache",  # or browsers would keep the page of an older covey
}


def make_app(served: str = "127.0.0.1") -> ASGIApp:
    """Return the application; `served` is the name under which it can be reached."""
    mimetypes.add_type("text/javascript", ".js")  # some machines map .js to another type
    app = Starlette(
        routes=[
            WebSocketRoute("/play", _play),
            WebSocketRoute("/{other:path}", WebSocketClose()),  # a Mount takes no WebSocket
            Mount("/", StaticFiles(directory=_FOLDER, html=True)),
        ],
    )
    app.state.pages = 0
    return Guard(app, served)


async def _play(websocket: WebSocket) -> None:
    state = websocket.app.state
    await websocket.accept()
    if state.pages >= MOST_PAGES:
        await websocket.close(_TRY_AGAIN_LATER, f"{MOST_PAGES} pages are being played already")
        return
    state.pages += 1
    try:
        await converse(websocket)
    finally:
        state.pages -= 1


class Guard:
    """Slows floods, refuses foreign hosts and origins, and adds the security headers."""

    def __init__(self, app: Starlette, served: str) -> None:
        self.app, self._served = app, served
        self._admission = Admission(_REQUESTS_PER_SECOND, _REQUESTS_AT_ONCE)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] not in {"http", "websocket"}:
            await self.app(scope, receive, send)
            return
        await asyncio.sleep(self._admission.wait(address_of(scope), time.monotonic()))
        headers = Headers(scope=scope)
        host = headers.get("host", "")
        refused = None
        if not is_own_host(host, self._served):
            refused = f"This server doesn't go by the name {host!r}."
        elif scope["type"] == "websocket" and not is_own_origin(headers.get("origin"), host):
            refused = "Only the page of this server may connect."
        if refused is None:
            await self.app(scope, receive, _with_headers(send))
        elif scope["type"] == "websocket":
            await WebSocketClose(reason=refused)(scope, receive, send)
        else:
            await PlainTextResponse(refused, 403)(scope, receive, send)


def _with_headers(send: Send) -> Send:
    async def send_with_headers(message: Message) -> None:
        if message["type"] == "http.response.start":
            MutableHeaders(scope=message).update(_HEADERS)
        await send(message)

    return send_with_headers
