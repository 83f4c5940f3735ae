"""The function that a worker runs, the result that it sends back, and when a worker ends."""

from __future__ import annotations

import os
import signal
import threading
import time
from typing import NamedTuple

from covey.studies.design.study import Study
from covey.studies.running.chunks import Chunk
from covey.studies.running.games import play_start
from covey.studies.running.provenance import code_digest
from covey.studies.running.tables import encoded, games_table, trajectories_table


class ChunkResult(NamedTuple):
    """The contents of a chunk's files, and how long the chunk took."""

    games: bytes
    trajectories: bytes | None
    seconds: float  # wall-clock time
    cpu_seconds: float
    playing_seconds: float  # wall-clock time without the making of tables


class OtherCodeError(Exception):
    """A worker's version of covey differs from that of the process that runs the study."""


_WATCH_SECONDS = 1.0


def depend_on_parent(parent: int) -> None:
    """Leave an interrupt to the parent of this process, and end when the parent has died.

    An interrupt from a terminal reaches every process. The parent stops the workers itself.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(_WATCH_SECONDS)
    os._exit(1)


def play_chunk(study: Study, chunk: Chunk, code: str) -> ChunkResult:
    """Play the games of a chunk."""
    if code_digest() != code:
        raise OtherCodeError("a worker has another version of covey; install the same everywhere")
    clock, cpu = time.perf_counter(), time.thread_time()
    games = [game for start in range(chunk.first, chunk.last) for game in play_start(study, start)]
    playing = time.perf_counter() - clock
    table = encoded(games_table(study, games))
    courses = encoded(trajectories_table(study, games)) if study.trajectories else None
    seconds, cpu_seconds = time.perf_counter() - clock, time.thread_time() - cpu
    return ChunkResult(table, courses, seconds, cpu_seconds, playing)
