"""What a bad page brings about: its own end at most, no other's, and one line in the log."""

from __future__ import annotations

import logging
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from contextlib import closing, contextmanager

import pytest
from websockets.exceptions import ConnectionClosed

from covey.web.game.session import Session
from covey.web.serving import app, protocol
from web import bad_pages
from web.bad_pages import (
    BYTES,
    CLOSE,
    FILM,
    NEW,
    NEW_LARGEST,
    PING,
    RUN,
    TEXT,
    frame,
    heard,
    raw_page,
)
from web.served_pages import hear, say, serving, wait_for


@pytest.fixture
def log(server):
    """What the server logs: formatted records, with their tracebacks."""
    lines = []

    class Lines(logging.Handler):
        def emit(self, record):
            lines.append(self.format(record))

    handler = Lines(logging.WARNING)
    loggers = [logging.getLogger(name) for name in ("uvicorn.error", "asyncio")]
    for logger in loggers:
        logger.addHandler(handler)
    yield lines
    for logger in loggers:
        logger.removeHandler(handler)


@contextmanager
def good_game(server):
    """Another page's game, which must go on: its time, before and after."""
    with server.page(close_timeout=1.0) as page:
        say(page, type="new", choices={"evaders": 3, "capture_radius": 0.01})
        hear(page, "reference")
        say(page, type="run", pace=0.25)
        before = hear(page, "frame")["time"]
        yield page
        while hear(page, "frame")["time"] <= before:
            pass


@pytest.mark.parametrize(
    ("sent", "code", "logged"),
    [
        (frame(TEXT, b"\xff\xfe"), 1007, "Invalid UTF-8"),
        (frame(3), 1002, None),
        (b"\xf1\x80" + bytes(4), 1002, None),  # reserved bits
        (b"\x81\x01x", 1002, None),  # not masked
        (frame(PING, bytes(126)), 1002, None),
        (frame(PING, final=False), 1002, None),
        (frame(0, b"x"), 1002, None),  # goes on with nothing
        (frame(TEXT, b"x", final=False) + frame(TEXT, b"y"), 1002, None),
        (b"\x81\xff\x7f" + bytes(11), 1009, None),  # announces 2⁶³ bytes
        # Two fragments of 9 MiB; the second is refused when it is announced.
        (frame(BYTES, bytes(9 * 2**20), final=False) + frame(0, bytes(9 * 2**20))[:14], 1009, None),
        (frame(CLOSE, b"x"), 1002, None),
        (frame(CLOSE, b"\x00\x01"), 1002, None),
        (frame(CLOSE, b"\x03\xe8\xff"), 1007, None),
    ],
)
def test_a_malformed_frame_ends_its_connection(server, log, sent, code, logged):
    with good_game(server):
        with raw_page(server.port) as raw:
            raw.sendall(frame(TEXT, NEW) + sent)
            last = heard(raw)
        close = last.rindex(b"\x88")
        assert int.from_bytes(last[close + 2 : close + 4], "big") == code
        wait_for(lambda: server.pages() == 1)
    assert len(log) == (logged is not None)
    assert all(logged in line and "\n" not in line for line in log)


@pytest.mark.parametrize("flood", [bad_pages.pings, bad_pages.endless_message])
def test_a_flood_that_is_no_message_ends_its_connection(server, log, monkeypatch, flood):
    # Less than otherwise, so that a busy machine needn't find the time for it.
    monkeypatch.setattr(protocol, "_SHARE", 0.001)
    monkeypatch.setattr(protocol, "_BURST", 0.05)
    with good_game(server):
        bad = threading.Thread(target=flood, args=(server.port, 30.0))
        began = time.monotonic()
        bad.start()
        bad.join()
        assert time.monotonic() < began + 25.0  # not by itself, which would be at 30
    assert log == ["A page was closed: it sent more than can be read."]


def test_of_a_flood_of_messages_a_game_gets_what_the_budget_allows(server, monkeypatch):
    steered, receive = [], Session.receive

    def counted(self, message, now):
        steered.append("steer" in message)
        return receive(self, message, now)

    monkeypatch.setattr(Session, "receive", counted)
    began = time.monotonic()
    bad_pages.flood(server.port, 1.0)
    wait_for(lambda: server.pages() == 0)
    assert 100 < sum(steered) <= 240 + 120 * (time.monotonic() - began)


@pytest.mark.parametrize(
    "bad", [bad_pages.flood, bad_pages.unread, bad_pages.slowly_read, bad_pages.reconnects]
)
def test_others_play_on_beside_a_bad_page(server, log, bad):
    with good_game(server) as page:
        thread = threading.Thread(target=bad, args=(server.port, 1.5))
        thread.start()
        times = []
        while thread.is_alive():
            times.append(hear(page, "frame")["time"])
        assert len(times) > 10
        assert times == sorted(times)
    wait_for(lambda: server.pages() == 0)
    assert log == []


def test_a_page_that_reads_nothing_is_closed_when_it_misses_a_ping(monkeypatch):
    """Cut off, and not closed when it has read what waits for it."""

    def more_than_the_network_holds(self, message, now):
        yield bytes(16 * 2**20)

    monkeypatch.setattr(Session, "receive", more_than_the_network_holds)
    with serving(ws_ping_interval=0.5, ws_ping_timeout=0.5) as server, raw_page(server.port) as raw:
        raw.sendall(frame(TEXT, RUN))
        wait_for(lambda: server.pages() == 1)
        wait_for(lambda: server.pages() == 0 and not server.connections())


def test_two_hundred_pages_at_once_and_one_more(server, log):
    wait_for(lambda: server.pages() == 0)
    with good_game(server):
        thread = threading.Thread(target=bad_pages.crowd, args=(server.port, 1.0, 199))
        thread.start()
        wait_for(lambda: server.pages() == app.MOST_PAGES)
        with server.page() as refused, pytest.raises(ConnectionClosed, match="200 pages"):
            refused.recv(timeout=10)
        thread.join()
    wait_for(lambda: server.pages() == 0)
    assert log == []


@pytest.mark.parametrize(
    ("request_", "status"),
    [
        ("GET /../connection.py HTTP/1.1", 404),
        ("GET /%2e%2e/connection.py HTTP/1.1", 404),
        ("GET /..%2fconnection.py HTTP/1.1", 404),
        ("GET /%2e%2e%2fconnection.py HTTP/1.1", 404),
        ("GET /..\\connection.py HTTP/1.1", 404),
        ("GET /..%5cconnection.py HTTP/1.1", 404),
        ("GET /x/../../connection.py HTTP/1.1", 404),
        ("GET //etc/passwd HTTP/1.1", 404),
        ("GET /%2fetc%2fpasswd HTTP/1.1", 404),
        ("GET /main.js%00.png HTTP/1.1", 404),
        ("GET /%ff HTTP/1.1", 404),
        ("GET http://elsewhere.example/ HTTP/1.1", 404),
        (f"GET /{'a' * 5000} HTTP/1.1", 404),
        ("POST / HTTP/1.1", 405),
        ("nonsense", 400),
    ],
)
def test_no_path_leads_out_of_the_page(server, log, request_, status):
    with closing(socket.create_connection(("127.0.0.1", server.port), timeout=10)) as raw:
        raw.sendall(f"{request_}\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n".encode())
        answer = heard(raw)
    assert answer.startswith(f"HTTP/1.1 {status} ".encode())
    assert b"import" not in answer
    assert log == (["Invalid HTTP request received."] if status == 400 else [])


def test_a_request_with_two_names_is_refused(server):
    with closing(socket.create_connection(("127.0.0.1", server.port), timeout=10)) as raw:
        raw.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nHost: elsewhere.example\r\n\r\n")
        assert heard(raw).startswith(b"HTTP/1.1 400 ")


def test_a_body_that_is_broken_is_one_line_in_the_log(server, log):
    for _ in range(3):  # the first answer of all takes longer, and then isn't tried
        with closing(socket.create_connection(("127.0.0.1", server.port), timeout=10)) as raw:
            raw.sendall(
                b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n"
            )
            assert heard(raw).startswith(b"HTTP/1.1 400 ")
    time.sleep(0.2)  # for the application, which answers in vain
    assert log == ["Invalid HTTP request received."] * 3


@pytest.mark.parametrize("path", ["/", "/main.js", "/other", "/play/", "/%2e%2e/play"])
def test_only_one_path_is_played_on(server, log, path):
    with closing(socket.create_connection(("127.0.0.1", server.port), timeout=10)) as raw:
        raw.sendall(
            f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nUpgrade: websocket\r\n"
            f"Origin: http://127.0.0.1:{server.port}\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Version: 13\r\n"
            "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n".encode()
        )
        assert re.match(rb"HTTP/1.1 (403|307) ", heard(raw))
    assert log == []


def test_the_server_ends_beside_a_page_that_reads_nothing_and_says_it_in_a_line(tmp_path):
    command = [sys.executable, "-m", "covey", "chase", "--port", "0", "--no-browser"]
    with (tmp_path / "errors").open("w") as errors:
        served = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True)
    port = int(re.search(r":(\d+)/", served.stdout.readline())[1])
    with raw_page(port) as raw:
        raw.sendall(frame(TEXT, NEW_LARGEST) + frame(TEXT, FILM) * 100)
        time.sleep(0.5)
        served.send_signal(signal.SIGINT)
        assert served.wait(timeout=20) == 0
    served.stdout.close()
    lines = (tmp_path / "errors").read_text().splitlines()
    assert len(lines) <= 2
    assert lines[-1] == "covey: stopped"
