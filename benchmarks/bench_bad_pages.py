"""How much a bad page slows another page's game. Run with `make bench ARGS='-k bad_pages'`.

A good page plays alone and beside the bad one, in turns. The ratio is that of the mean times
between frames. The bad page has another address, as if it were on another machine, since the server
shares its time among addresses. It competes for this machine's processors all the same, as do the
server, its worker and the good page, each a process of its own. On fewer free cores than busy
processes, the ratios show more than the server is to blame for.
"""

from __future__ import annotations

import json
import multiprocessing
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from websockets.sync.client import connect

from web import bad_pages
from web.bad_pages import BAD_PAGES

ROUNDS, SECONDS = 3, 5.0
AT_FIRST = 4.0
"""Seconds in which a bad page uses up what it may take at once."""


@pytest.fixture(scope="module")
def port():
    command = [sys.executable, "-m", "covey", "chase", "--port", "0", "--no-browser"]
    served = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    yield int(re.search(r":(\d+)/", served.stdout.readline())[1])
    served.send_signal(signal.SIGINT)
    served.wait()
    served.stdout.close()


def frames(page, seconds):
    """Play on, and return the times between frames."""
    times, ends = [], time.monotonic() + seconds
    while time.monotonic() < ends:
        frame = json.loads(page.recv(timeout=60.0))
        if frame["type"] == "frame":
            times.append(time.monotonic())
            page.send(json.dumps({"type": "steer", "heading": frame["time"]}))
    return np.diff(times)


def from_another_machine(bad, port, seconds):
    """Needs a system that answers to all of 127.0.0.0/8, as Linux does."""
    bad_pages.address = "127.0.0.2"
    bad(port, seconds)


def ratio(beside, alone):
    """The median over rounds of the ratio of mean times between frames."""
    means = [np.mean(gaps) / np.mean(own) for gaps, own in zip(beside, alone, strict=True)]
    return float(np.median(means))


@pytest.mark.parametrize("bad", BAD_PAGES, ids=lambda bad: bad.__name__)
def test_bad_pages(benchmark, port, bad):
    alone, at_first, beside = [], [], []

    def play_beside_and_alone():
        with connect(f"ws://127.0.0.1:{port}/play", origin=f"http://127.0.0.1:{port}") as page:
            page.send(json.dumps({"type": "new", "choices": {"capture_radius": 0.01}}))
            page.send(json.dumps({"type": "run", "pace": 0.5}))
            frames(page, 0.5)
            alone.append(frames(page, SECONDS))
            process = multiprocessing.Process(
                target=from_another_machine, args=(bad, port, AT_FIRST + SECONDS)
            )
            process.start()
            at_first.append(frames(page, AT_FIRST))
            beside.append(frames(page, SECONDS))
            page.send(json.dumps({"type": "pause"}))
        process.join()

    benchmark.group = "frames of a game beside a bad page"
    benchmark.pedantic(play_beside_and_alone, rounds=ROUNDS)
    before, then = ratio(at_first, alone), ratio(beside, alone)
    benchmark.extra_info |= {"ratio at first": round(before, 3), "ratio then": round(then, 3)}
    print(
        f"\nbeside {bad.__name__}: frames are {before:.2f} times as far apart at first, "
        f"then {then:.2f} times"
    )
