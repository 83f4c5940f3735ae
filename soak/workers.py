"""Processes that play seeds, each its share, and tell how far they are once a second."""

from __future__ import annotations

import multiprocessing
import os
import signal
import time
from multiprocessing.connection import wait
from pathlib import Path
from typing import NamedTuple

from soak.totals import Totals
from soak.trial import ViolationError, play

REPORT_EVERY = 1.0
"""Seconds between two reports of a worker."""
PATIENCE = 600.0
"""Seconds without a report after which a game counts as one that never ends."""


class Report(NamedTuple):
    """What a worker did since its last report."""

    worker: int
    totals: Totals
    megabytes: float  # of memory, resident now
    cpu_seconds: float  # since the worker's start
    failure: tuple[int, str] | None  # seed and message; the worker has ended


def play_share(worker, seeds, connection, current):
    """Play seeds until they are used up, a game fails, or nobody listens any more."""
    totals, reported, failure = Totals(), time.monotonic(), None
    try:
        for seed in seeds:
            current.value = seed
            try:
                totals.add(play(seed))
            except ViolationError as error:
                failure = (seed, str(error))
                break
            if time.monotonic() - reported > REPORT_EVERY:
                connection.send(_report(worker, totals, None))
                totals, reported = Totals(), time.monotonic()
        connection.send(_report(worker, totals, failure))
    except BrokenPipeError:
        pass  # the parent has ended
    connection.close()


def reports(first, last, workers):
    """Yield what the workers report of the seeds from `first` to before `last`; None: no end.

    Worker k plays each seed whose distance from `first` leaves k when divided by `workers`. A
    worker that dies, or whose game never ends, is reported as a failure of the seed that it played.
    When the generator is closed, the workers are ended.
    """
    stop = last if last is not None else 2**62
    playing = {}
    listening = signal.signal(signal.SIGINT, signal.SIG_IGN)  # workers never hear it
    for k in range(workers):
        connection, *started = _start(k, range(first + k, stop, workers))
        playing[connection] = [k, *started, time.monotonic()]
    signal.signal(signal.SIGINT, listening)
    try:
        while playing:
            for connection in wait(list(playing), timeout=REPORT_EVERY):
                k, process, current, _ = playing[connection]
                try:
                    yield connection.recv()
                    playing[connection][3] = time.monotonic()
                except EOFError:
                    process.join()
                    del playing[connection]
                    if process.exitcode != 0:
                        yield _lost(k, current.value, f"the worker died, exit {process.exitcode}")
            for k, _, current, heard in playing.values():
                if time.monotonic() - heard > PATIENCE:
                    yield _lost(k, current.value, f"no end after {PATIENCE:g} s")
    finally:
        for _, process, _, _ in playing.values():
            process.kill()


def _start(worker, share):
    """Start a process that plays a share of the seeds; return what tells of it."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    current = context.Value("q", share.start, lock=False)
    process = context.Process(target=play_share, args=(worker, share, theirs, current), daemon=True)
    process.start()
    theirs.close()
    return ours, process, current


def resident_megabytes():
    """Return the memory that this process holds now (on Linux; elsewhere 0)."""
    pages = Path("/proc/self/statm")
    if not pages.exists():
        return 0.0
    return int(pages.read_text(encoding="ascii").split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def _report(worker, totals, failure):
    return Report(worker, totals, resident_megabytes(), time.process_time(), failure)


def _lost(worker, seed, reason):
    return Report(worker, Totals(), 0.0, 0.0, (seed, f"seed {seed}: {reason}"))
