"""Pages as a broken or malicious program would open them. Each takes a port, and some seconds."""

from __future__ import annotations

import json
import os
import selectors
import socket
import struct
import time
from contextlib import ExitStack, contextmanager, suppress

NEW = json.dumps({"type": "new", "choices": {"evaders": 1, "capture_radius": 0.01}}).encode()
NEW_OF_FIVE = json.dumps({"type": "new", "choices": {"capture_radius": 0.01}}).encode()
LARGEST = {"evaders": 10, "capture_radius": 0.01, "speed": 0.5, "pursuer_speed": 1.2}
NEW_LARGEST = json.dumps({"type": "new", "choices": LARGEST}).encode()
FILM = b'{"type": "film", "game": "reference"}'
RUN = b'{"type": "run"}'

address = "127.0.0.1"
"""Of the machine that the pages are on. The server knows machines by it."""

TEXT, BYTES, CLOSE, PING = 1, 2, 8, 9


def frame(opcode, content=b"", *, final=True):
    """A WebSocket frame as a client sends it, masked with zeros."""
    size = len(content)
    if size < 126:
        length = bytes([0x80 | size])
    elif size < 2**16:
        length = struct.pack("!BH", 0x80 | 126, size)
    else:
        length = struct.pack("!BQ", 0x80 | 127, size)
    return bytes([opcode | 0x80 * final]) + length + bytes(4) + content


@contextmanager
def raw_page(port, wait=10.0):
    """A socket after the handshake of a page. It hears little at once."""
    with socket.create_connection(("127.0.0.1", port), wait, (address, 0)) as raw:
        raw.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        raw.sendall(
            f"GET /play HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\n"
            "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
            "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n".encode()
        )
        answer = b""
        while b"\r\n\r\n" not in answer:
            answer += raw.recv(4096)
        yield raw


def heard(raw):
    """All that comes until the other side closes."""
    content = b""
    with suppress(OSError):
        while more := raw.recv(4096):
            content += more
    return content


def write(raw, content, ends):
    """Send, frame after frame, what the other side takes until then."""
    raw.settimeout(0.2)
    left = memoryview(content)
    while left and time.monotonic() < ends:
        with suppress(TimeoutError):
            left = left[raw.send(left) :]


def pour(port, seconds, first, then):
    """Send the same again and again, and read nothing."""
    ends = time.monotonic() + seconds
    with suppress(OSError), raw_page(port) as raw:
        raw.sendall(first)
        while time.monotonic() < ends:
            write(raw, then, ends)


def pings(port, seconds):
    pour(port, seconds, b"", frame(PING) * 1000)


def endless_message(port, seconds):
    """A message of empty fragments."""
    pour(port, seconds, frame(TEXT, b"x", final=False), frame(0, final=False) * 1000)


def flood(port, seconds):
    """20 000 messages a second, beside a game."""
    burst = frame(TEXT, b'{"type": "steer", "heading": 1.0}') * 1000
    with suppress(OSError), raw_page(port) as raw:
        raw.sendall(frame(TEXT, NEW) + frame(TEXT, RUN))
        began, sent = time.monotonic(), 0
        while (now := time.monotonic()) < began + seconds:
            if sent < 20_000 * (now - began):
                write(raw, burst, began + seconds)
                sent += 1000
            else:
                time.sleep(0.005)


def unread(port, seconds):
    """Ask for large answers, and read none."""
    ends = time.monotonic() + seconds
    with suppress(OSError), raw_page(port) as raw:
        raw.sendall(frame(TEXT, NEW_LARGEST))
        while time.monotonic() < ends:
            raw.sendall(frame(TEXT, FILM))
            time.sleep(0.05)


def slowly_read(port, seconds):
    """Read a film in small bites."""
    ends = time.monotonic() + seconds
    with suppress(OSError), raw_page(port, wait=1.0) as raw:
        raw.sendall(frame(TEXT, NEW_LARGEST) + frame(TEXT, FILM) * 50)
        while time.monotonic() < ends and raw.recv(1000):
            time.sleep(0.01)


def greedy(port, seconds, request):
    """Ask for the same again as soon as it is answered."""
    ends = time.monotonic() + seconds
    with suppress(OSError), raw_page(port, wait=1.0) as raw:
        raw.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2**20)
        raw.sendall(frame(TEXT, NEW_LARGEST))
        while time.monotonic() < ends:
            raw.sendall(request)
            with suppress(TimeoutError):
                raw.recv(2**20)
            time.sleep(0.02)


def films(port, seconds):
    greedy(port, seconds, frame(TEXT, FILM))


def games(port, seconds):
    greedy(port, seconds, frame(TEXT, NEW_LARGEST))


def uploads(port, seconds):
    """16 MiB that are no record."""
    size = 16 * 2**20
    greedy(port, seconds, frame(BYTES, b"PAR1" + os.urandom(size - 8) + b"PAR1"))


def crowd_of_games(port, seconds):
    crowd(port, seconds, first=frame(TEXT, NEW))


def crowd_of_running_games(port, seconds):
    """On each page runs a game of five, as fast as it can. Larger ones wait longer to be set up."""
    reading_crowd(
        port, seconds, frame(TEXT, NEW_OF_FIVE) + frame(TEXT, b'{"type": "run", "pace": 2.0}')
    )


def crowd_of_films(port, seconds):
    """Each page asks for film after film."""
    reading_crowd(port, seconds, frame(TEXT, NEW_OF_FIVE) + frame(TEXT, FILM) * 50)


def reconnects(port, seconds):
    """Ask for a large game and go, at once and again."""
    ends = time.monotonic() + seconds
    while time.monotonic() < ends:
        with suppress(OSError), raw_page(port) as raw:
            raw.sendall(frame(TEXT, NEW_LARGEST))


def requests(port, seconds):
    """Ask for a file again and again, on many connections."""
    asked = f"GET /main.js HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode() * 20
    with suppress(OSError), ExitStack() as sockets:
        raws = [
            sockets.enter_context(socket.create_connection(("127.0.0.1", port), 1.0, (address, 0)))
            for _ in range(20)
        ]
        read_until(raws, time.monotonic() + seconds, first=asked, answer=asked)


def reading_crowd(port, seconds, first, count=20):
    """Many pages at once, which read whatever comes."""
    ends = time.monotonic() + seconds
    with suppress(OSError), ExitStack() as pages:
        raws = [pages.enter_context(raw_page(port)) for _ in range(count)]
        read_until(raws, ends, first)


def read_until(raws, ends, first, answer=b""):
    """Send `first` to all, read what comes, and send `answer` to it."""
    with selectors.DefaultSelector() as selector:
        for raw in raws:
            raw.sendall(first)
            selector.register(raw, selectors.EVENT_READ)
        while time.monotonic() < ends:
            for key, _ in selector.select(0.1):
                if key.fileobj.recv(2**16):
                    key.fileobj.sendall(answer)
                else:
                    selector.unregister(key.fileobj)


def crowd(port, seconds, count=190, first=b""):
    """Many pages at once, which wait."""
    with ExitStack() as pages:
        for _ in range(count):
            pages.enter_context(raw_page(port)).sendall(first)
        time.sleep(seconds)


BAD_PAGES = (
    pings,
    endless_message,
    flood,
    unread,
    slowly_read,
    films,
    games,
    uploads,
    reconnects,
    crowd_of_games,
    crowd_of_running_games,
    crowd_of_films,
    requests,
)
