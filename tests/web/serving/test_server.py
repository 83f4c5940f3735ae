"""The server as a network sees it: who gets in, what it withstands, what it does when full."""

from __future__ import annotations

import http.client
import json
import os
import re
import socket
import threading
import time
from contextlib import closing, suppress
from pathlib import Path

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

import covey.web
from covey.model import InputError
from covey.web import worker as module
from covey.web.game.human_game import UPDATE_TIME
from covey.web.game.session import Session
from covey.web.serving import app
from covey.web.serving.fair_threads import FairThreads
from covey.web.serving.origin import is_own_host, is_own_origin
from covey.web.serving.server import listen, page_address
from web.served_pages import hear, say, wait_for

FILES = Path(covey.web.__file__).parent / "page"


def get(server, path, host=None):
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)
    with closing(connection):
        connection.request("GET", path, headers={} if host is None else {"Host": host})
        response = connection.getresponse()
        return response, response.read()


@pytest.mark.parametrize("name", sorted(path.name for path in FILES.iterdir()))
def test_the_page_is_served(server, name):
    response, content = get(server, f"/{name}")
    assert response.status == 200
    assert content == (FILES / name).read_bytes()
    assert "default-src 'none'" in response.headers["content-security-policy"]
    if name.endswith(".js"):
        assert response.headers["content-type"].startswith("text/javascript")


def test_nothing_else_is_served(server):
    assert get(server, "/")[1] == (FILES / "index.html").read_bytes()
    for path in ("/nothing", "/../server.py", "/%2e%2e/server.py", "/play"):
        assert get(server, path)[0].status == 404


def test_no_file_comes_from_elsewhere():
    for path in FILES.iterdir():
        addresses = re.findall(r"(?:https?:)?//[\w.]+\.\w+", path.read_text())
        assert not [each for each in addresses if "www.w3.org" not in each], path


@pytest.mark.parametrize("origin", [None, "null", "http://elsewhere.example", "http://127.0.0.1:1"])
def test_a_page_from_elsewhere_is_turned_away(server, origin):
    with pytest.raises(InvalidStatus) as refused:
        server.page(origin=origin)
    assert refused.value.response.status_code == 403


def test_a_name_that_was_made_to_lead_here_is_turned_away(server):
    host = f"elsewhere.example:{server.port}"
    assert get(server, "/", host)[0].status == 403
    assert get(server, "/", f"localhost:{server.port}")[0].status == 200


@pytest.mark.parametrize(
    ("host", "own"),
    [
        ("127.0.0.1:80", True),
        ("localhost", True),
        ("[::1]:80", True),
        ("192.168.1.5:8014", True),
        ("hawk.local:8014", True),
        ("dove.local:8014", False),
        ("127.0.0.1.example", False),
        ("127.0.0.1@elsewhere.example", False),
        ("127.0.0.1:80:elsewhere.example", False),
        ("2130706433", False),
        ("localhost.elsewhere.example", False),
        ("", False),
        ("[", False),
    ],
)
def test_names_of_this_machine(host, own):
    assert is_own_host(host, "hawk.local") is own


def test_origin_is_scheme_name_and_port():
    assert is_own_origin("http://127.0.0.1:80", "127.0.0.1:80")
    assert is_own_origin("https://hawk.local", "hawk.local")
    assert not is_own_origin("http://127.0.0.1:81", "127.0.0.1:80")
    assert not is_own_origin("ftp://127.0.0.1:80", "127.0.0.1:80")


def test_a_game_over_the_network(server):
    with server.page() as page:
        say(page, type="new", choices={"evaders": 2, "seed": 3})
        game = hear(page, "game")
        reference = hear(page, "reference")
        assert reference["survival_time"] >= game["cast"]["guarantee"] - 1e-9
        say(page, type="run", pace=2.0)
        say(page, type="steer", heading=1.0)
        frames = (hear(page, "frame") for _ in range(200))  # some come before the turn
        assert any(frame["pursuer"][1] > 0.0 for frame in frames)
        page.send("nonsense")
        assert "JSON" in hear(page, "error")["text"]
        page.send("x" * 10**6)
        assert "at most 2000 characters" in hear(page, "error")["text"]
        page.send(b"no record")
        assert "Parquet" in hear(page, "error")["text"]
        time = hear(page, "frame")["time"]
        assert hear(page, "frame")["time"] > time


def test_a_flood_is_dropped_and_the_game_goes_on(server):
    with server.page(close_timeout=1.0) as page:
        say(page, type="new", choices={"evaders": 1, "seed": 3})
        hear(page, "reference")
        say(page, type="run", pace=1.0)
        text = json.dumps({"type": "steer", "heading": 1.0})
        for _ in range(3000):
            page.send(text)
        assert "messages a second" in hear(page, "error")["text"]
        time = hear(page, "frame")["time"]
        assert hear(page, "frame")["time"] > time


def test_too_much_at_once_ends_the_connection_and_no_other(server):
    with server.page() as other, server.page() as page:
        with suppress(ConnectionClosed):  # before all of it is sent, or after
            page.send(bytes(17 * 2**20))
        with pytest.raises(ConnectionClosed):
            page.recv(timeout=10)
        say(other, type="new", choices={"evaders": 1})
        hear(other, "game")


def test_closing_a_page_ends_its_game(server, monkeypatch):
    steps, advance = [], Session.advance

    def counted(self, now):
        steps.append(now)
        return advance(self, now)

    monkeypatch.setattr(Session, "advance", counted)
    wait_for(lambda: server.pages() == 0)
    with server.page() as page:
        say(page, type="new", choices={"evaders": 2, "sensing": "hidden"})
        hear(page, "reference")
        say(page, type="run", pace=0.25)
        hear(page, "frame")
        assert server.pages() == 1
    wait_for(lambda: server.pages() == 0)
    time.sleep(0.1)  # a step that was under way may end
    count = len(steps)
    time.sleep(0.3)
    assert len(steps) == count > 0


def test_a_page_that_vanishes_ends_its_game_too(server):
    with server.page() as page:
        say(page, type="new", choices={"evaders": 2})
        hear(page, "reference")
        say(page, type="run")
        hear(page, "frame")
        page.socket.shutdown(socket.SHUT_RDWR)
        wait_for(lambda: server.pages() == 0)


def test_one_page_too_many_is_told_so(server, monkeypatch):
    monkeypatch.setattr(app, "MOST_PAGES", 1)
    wait_for(lambda: server.pages() == 0)
    with server.page() as first:
        say(first, type="new", choices={"evaders": 1})
        hear(first, "game")
        with server.page() as second:
            with pytest.raises(ConnectionClosed):
                second.recv(timeout=10)
            assert second.protocol.close_code == 1013
            assert "1 pages" in second.protocol.close_reason


def fly(server, seconds, seen):
    """Fly in circles; note for each frame when it came, the game's time and the rate."""
    with server.page() as page:
        say(page, type="new", choices={"evaders": 5, "capture_radius": 0.01, "seed": 1})
        hear(page, "reference", timeout=600.0)  # one process plays those of all pages
        say(page, type="run", pace=1.0)
        frames, began = [], time.monotonic()
        while time.monotonic() < began + seconds:
            frame = hear(page, "frame")
            frames.append((time.monotonic(), frame["time"], frame["rate"]))
            say(page, type="steer", heading=frame["time"])
        seen.append(frames)


def pace_and_rate(frames):
    """How fast the game ran beside the clock on the wall, and what was shown, after a second."""
    steady = [frame for frame in frames if frame[0] > frames[0][0] + 1.0]
    (since, before, _), (last, time, _) = steady[0], steady[-1]
    return (time - before) / (last - since), np.mean([rate for _, _, rate in steady])


def test_an_address_cannot_be_made_up(server, monkeypatch):
    users, submit = set(), FairThreads.submit

    def noted(self, user, call):
        users.add(user)
        return submit(self, user, call)

    monkeypatch.setattr(FairThreads, "submit", noted)
    with server.page(additional_headers={"X-Forwarded-For": "192.0.2.1"}) as page:
        say(page, type="new", choices={"evaders": 1})
        hear(page, "game")
    assert users == {"127.0.0.1"}


@pytest.fixture
def worker():
    """The process in which a server plays reference games."""
    module.worker.start()
    yield module.worker
    module.worker.stop()


def test_fifty_pages_slow_down_and_say_so(server, worker):
    assert worker.call(os.getpid) != os.getpid()  # it has begun
    seen = []
    pages = [threading.Thread(target=fly, args=(server, 4.0, seen)) for _ in range(50)]
    for page in pages:
        page.start()
    for page in pages:
        page.join()
    assert len(seen) == 50  # nothing broke, and nobody was left behind
    paces, rates = np.transpose([pace_and_rate(frames) for frames in seen])
    assert paces.min() > 0.0
    assert paces.mean() < 1.05  # slower, never faster, to make up for it
    # What is shown is true: an update is as long as ever, so the pace tells how many there were.
    assert rates.mean() * UPDATE_TIME == pytest.approx(paces.mean(), rel=0.3)
    print(f"\n50 pages: {rates.mean():.0f} plans a second each, the slowest {rates.min():.0f}")
    wait_for(lambda: server.pages() == 0)


def test_listening_where_one_cannot_is_a_clear_error(server):
    with pytest.raises(InputError, match=r"can't listen on 127.0.0.1, port .*--port"):
        listen("127.0.0.1", server.port)
    with pytest.raises(InputError, match="can't listen on no such host"):
        listen("no such host", 0)


@pytest.mark.parametrize(
    ("host", "address"),
    [
        ("127.0.0.1", "http://127.0.0.1:80/"),
        ("0.0.0.0", "http://127.0.0.1:80/"),
        ("::", "http://[::1]:80/"),
        ("::1", "http://[::1]:80/"),
        ("localhost", "http://localhost:80/"),
    ],
)
def test_the_address_that_is_printed(host, address):
    assert page_address(host, 80) == address
