"""A server on a port of its own, and pages that are programs."""

from __future__ import annotations

import json
import threading
import time
from contextlib import contextmanager

import uvicorn
from websockets.sync.client import connect

from covey.web.serving.server import configuration, listen, warm_up


class Served:
    """A server that runs in a thread."""

    def __init__(self, port, pages, connections):
        self.port, self.pages, self.connections = port, pages, connections
        self.address = f"http://127.0.0.1:{port}"

    def page(self, **options):
        """A WebSocket, as the page opens it."""
        options.setdefault("origin", self.address)
        options.setdefault("compression", None)
        return connect(f"ws://127.0.0.1:{self.port}/play", max_size=None, **options)


@contextmanager
def serving(**settings):
    """A server, with other settings of uvicorn than its own where they are given."""
    warm_up()  # pages wait for answers, and not for the compiler
    listener = listen("127.0.0.1", 0)
    config = configuration("127.0.0.1")
    for name, value in settings.items():
        setattr(config, name, value)
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]})
    thread.start()
    state = config.app.app.state
    try:
        while not server.started:
            time.sleep(0.01)
        yield Served(
            listener.getsockname()[1],
            lambda: state.pages,
            lambda: len(server.server_state.connections),
        )
    finally:
        server.should_exit = True
        thread.join()
        listener.close()


def say(page, **message):
    page.send(json.dumps(message))


def hear(page, kind, timeout=30.0):
    """The next message of this type; others are passed over."""
    ends = time.monotonic() + timeout
    while time.monotonic() < ends:
        message = page.recv(timeout=ends - time.monotonic())
        if isinstance(message, bytes):
            if kind == "file":
                return message
        elif (heard := json.loads(message))["type"] == kind:
            return heard
    raise TimeoutError(kind)


def wait_for(condition, timeout=10.0):
    ends = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < ends
        time.sleep(0.02)
