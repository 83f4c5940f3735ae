"""One WebSocket: reads messages within a rate limit, runs the session, sends its replies."""

from __future__ import annotations

import asyncio
import json
import time

from starlette.websockets import WebSocket, WebSocketDisconnect

from covey.web.rate_limit import TokenBucket
from covey.web.session import Reply, Session, error_reply

_FRAME = 1.0 / 60.0
"""Seconds between two frames: enough for every screen, since the page interpolates."""

_MESSAGES_PER_SECOND = 120.0
_FILE_COSTS = 60.0
_MOST_WAITING = 64

Inbox = asyncio.Queue[str | bytes]


async def converse(websocket: WebSocket) -> None:
    """Serve a page until it is closed. Its game ends then."""
    inbox: Inbox = asyncio.Queue(_MOST_WAITING)
    tasks = [
        asyncio.create_task(_read(websocket, inbox)),
        asyncio.create_task(_play(websocket, inbox)),
    ]
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in done:
            task.result()
    except WebSocketDisconnect:
        pass
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)


async def _read(websocket: WebSocket, inbox: Inbox) -> None:
    """Pass messages on. Those beyond the limit are dropped; the page is told once a second."""
    limit = TokenBucket(_MESSAGES_PER_SECOND, 2.0 * _MESSAGES_PER_SECOND)
    complaints = TokenBucket(1.0, 1.0)
    while True:
        event = await websocket.receive()
        if event["type"] == "websocket.disconnect":
            raise WebSocketDisconnect(event.get("code", 1000))
        message = event.get("text")
        cost = 1.0
        if message is None:
            message, cost = event["bytes"], _FILE_COSTS
        if limit.take(time.monotonic(), cost):
            await inbox.put(message)
        elif complaints.take(time.monotonic()):
            text = f"expected at most {_MESSAGES_PER_SECOND:g} messages a second; some were dropped"
            await _send(websocket, error_reply(text))


async def _play(websocket: WebSocket, inbox: Inbox) -> None:
    """Answer the messages that have come and play the updates that are due, frame by frame.

    Both happen in a thread, since kernels release the interpreter's lock. One thread answers all
    messages of a frame, so messages that come fast don't queue up.
    """
    session = Session()
    while True:
        began = time.monotonic()
        messages = [] if session.busy else [await inbox.get()]
        while not inbox.empty():
            messages.append(inbox.get_nowait())
        for reply in await asyncio.to_thread(_replies, session, messages):
            await _send(websocket, reply)
        if session.busy:
            await asyncio.sleep(max(0.0, began + _FRAME - time.monotonic()))


def _replies(session: Session, messages: list[str | bytes]) -> list[Reply]:
    replies: list[Reply] = []
    for message in messages:
        replies += session.receive(message, time.monotonic())
    if not replies:  # replies are sent before more is computed
        replies += session.advance(time.monotonic())
    return replies


async def _send(websocket: WebSocket, reply: Reply) -> None:
    if isinstance(reply, bytes):
        await websocket.send_bytes(reply)
    else:
        await websocket.send_text(json.dumps(reply, allow_nan=False))
