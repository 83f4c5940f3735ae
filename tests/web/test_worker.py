"""The process of what takes long: what is called there, and what ends it."""

from __future__ import annotations

import gc
import json
import os
import signal
import subprocess
import sys

import pytest

import covey
from covey.simulation.storage import read_game
from covey.web import worker as module
from covey.web.game.session import Session
from covey.web.serving import server
from covey.web.worker import Worker
from web.served_pages import hear, say, serving, wait_for

posix = pytest.mark.skipif(os.name != "posix", reason="signals and niceness of Unix")


@pytest.fixture(scope="module")
def worker():
    worker = Worker()
    worker.start()
    yield worker
    worker.stop()


def refuse(text):
    raise covey.InputError(text)


def test_without_a_process_of_its_own_it_calls_here():
    assert Worker().call(os.getpid) == os.getpid()


def test_it_calls_in_another_process_and_says_what_went_wrong_there(worker):
    assert worker.call(os.getpid) != os.getpid()
    assert worker.call(sorted, [2, 1], reverse=True) == [2, 1]
    with pytest.raises(covey.InputError, match="no such game"):
        worker.call(refuse, "no such game")


@posix
def test_it_has_a_lower_priority(worker):
    assert worker.call(os.nice, 0) == min(os.nice(0) + 10, 19)


@pytest.fixture
def interruptible():
    """Some shells start what runs in the background so that it ignores interrupts."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@posix
def test_an_interrupt_is_left_to_the_server(interruptible):
    worker = Worker()
    worker.start()
    assert worker.call(signal.getsignal, signal.SIGINT) == signal.SIG_IGN
    worker.stop()


def test_a_process_that_died_is_replaced(worker):
    with pytest.raises(covey.InputError, match="broke off what was asked for"):
        worker.call(os._exit, 1)
    assert worker.call(os.getpid) != os.getpid()


def alive(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


@posix
def test_it_ends_with_a_server_that_was_killed(tmp_path):
    program = tmp_path / "server.py"
    program.write_text(
        "import os, time\n"
        "from covey.web.worker import Worker\n"
        "if __name__ == '__main__':\n"
        "    worker = Worker()\n"
        "    worker.start()\n"
        "    print(worker.call(os.getpid), flush=True)\n"
        "    worker.call(time.sleep, 60)\n"
    )
    with subprocess.Popen([sys.executable, program], stdout=subprocess.PIPE, text=True) as parent:
        process = int(parent.stdout.readline())
        assert alive(process)
        parent.kill()
    wait_for(lambda: not alive(process))


def test_films_files_uploads_and_the_reference_game_are_made_there(monkeypatch):
    called = []

    def call(function, *arguments, **options):
        called.append(function.__name__)
        return function(*arguments, **options)

    monkeypatch.setattr(module.worker, "call", call)
    session = Session()
    wanted = [{"type": kind, "game": "reference"} for kind in ("film", "save")]
    texts = map(json.dumps, [{"type": "new", "choices": {"evaders": 1}}, *wanted])
    messages = [*texts, b""]
    for message in messages:
        list(session.receive(message, 0.0))
    assert called == ["simulate", "simulate", "film", "_file", "read_upload"]


def test_the_server_has_one_until_it_ends(monkeypatch):
    processes = []

    class Server:
        def __init__(self, config):
            pass

        def run(self, sockets):
            processes.append(module.worker.call(os.getpid))

    monkeypatch.setattr(server.uvicorn, "Server", Server)
    server.serve("127.0.0.1", 0, open_browser=False)
    gc.unfreeze()
    processes.append(module.worker.call(os.getpid))
    assert processes[0] != processes[1] == os.getpid()


def test_a_page_notices_nothing_of_it(worker, monkeypatch):
    monkeypatch.setattr(module.worker, "_pool", worker._pool)
    with serving() as served, served.page() as page:
        say(page, type="new", choices={"evaders": 2, "seed": 3})
        time = hear(page, "reference")["survival_time"]
        say(page, type="film", game="reference")
        assert hear(page, "film")["survival_time"] == time
        say(page, type="save", game="reference")
        content = hear(page, "file")
        assert read_game(content, "saved").survival_time == time
        page.send(content)
        assert hear(page, "film")["game"] == "opened"
        page.send(b"no record")
        assert "Parquet" in hear(page, "error")["text"]
