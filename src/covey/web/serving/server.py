"""Serve the page from this machine until Ctrl-C."""

from __future__ import annotations

import asyncio
import gc
import json
import logging
import socket
import sys
import webbrowser
from contextlib import suppress
from threading import Thread
from typing import Any

import h11
import uvicorn

from covey.model import InputError
from covey.web.game.session import Session
from covey.web.game.upload import MOST_BYTES
from covey.web.serving.app import make_app
from covey.web.serving.protocol import LimitedProtocol
from covey.web.worker import worker

_GRACE = 1
"""Seconds for open pages to close when the server ends."""

_SAID_ALREADY = (asyncio.CancelledError, h11.LocalProtocolError)
"""What uvicorn logs a second time: a page that doesn't end with the server, an invalid request."""


def serve(host: str, port: int, *, open_browser: bool) -> None:
    """Serve the page, print its address, and return after Ctrl-C.

    Raises
    ------
    InputError
        If the server can't listen on the address.
    """
    listener = listen(host, port)
    with listener:
        worker.start()
        warm_up()
        gc.freeze()  # what stays is not looked through again, which would stop every game for 40 ms
        address = page_address(host, listener.getsockname()[1])
        print(f"covey: the page is at {address}\nCtrl-C ends it.", flush=True)
        if open_browser:
            # In a thread: a browser in the terminal returns only when it is closed.
            Thread(target=webbrowser.open, args=[address], daemon=True).start()
        server = uvicorn.Server(configuration(host))
        with suppress(KeyboardInterrupt):  # uvicorn raises Ctrl-C again once it has shut down
            server.run(sockets=[listener])
        worker.stop()
        print("covey: stopped", file=sys.stderr)


def configuration(host: str) -> uvicorn.Config:
    """Return the configuration of the server, and let it log what clients do wrong in one line."""
    logging.getLogger("uvicorn.error").addFilter(_one_line)
    return uvicorn.Config(
        make_app(host),
        log_level="warning",
        access_log=False,
        server_header=False,
        proxy_headers=False,  # anybody can write them, and pass for another address
        ws=LimitedProtocol,
        ws_max_size=MOST_BYTES,
        ws_per_message_deflate=False,  # frames are small, and the network is short
        timeout_graceful_shutdown=_GRACE,
    )


def _one_line(record: logging.LogRecord) -> bool:
    """Drop the traceback of what a client has brought about, or the whole record."""
    error = record.exc_info[1] if record.exc_info else None
    if isinstance(error, UnicodeDecodeError):
        record.exc_info = None
    return not isinstance(error, _SAID_ALREADY)


def listen(host: str, port: int) -> socket.socket:
    """Return a socket that listens; port 0 takes any that is free."""
    try:
        family, *_, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        return _bound(family, address)
    except OSError as error:
        raise InputError(
            f"can't listen on {host}, port {port}: {error.strerror}; "
            "choose another port with --port, or leave the choice to covey with --port 0"
        ) from error


def _bound(family: socket.AddressFamily, address: tuple[Any, ...]) -> socket.socket:
    listener = socket.socket(family, socket.SOCK_STREAM)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen()  # connections before the server is ready wait, and aren't refused
    except OSError:
        listener.close()
        raise
    return listener


def page_address(host: str, port: int) -> str:
    """Return the page's address as this machine reaches it."""
    name = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(host, host)
    return f"http://{f'[{name}]' if ':' in name and name[0] != '[' else name}:{port}/"


def warm_up() -> None:
    """Load the kernels, or compile them, before the first page asks for a game."""
    session = Session()
    for sensing, team in (("visible", "iterative-open-loop"), ("hidden", "largest-distance")):
        choices = {"evaders": 2, "sensing": sensing, "team": team}
        for message in ({"type": "new", "choices": choices}, {"type": "step"}):
            list(session.receive(json.dumps(message), 0.0))
            list(session.advance(0.0))
