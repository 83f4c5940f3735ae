"""What is sent to a worker, and what comes back."""

from __future__ import annotations

import time
from typing import NamedTuple

from covey.studies.design.study import Study
from covey.studies.running.chunks import Chunk
from covey.studies.running.games import play_start
from covey.studies.running.provenance import code_digest
from covey.studies.running.tables import encoded, games_table, moments_table


class Parts(NamedTuple):
    """The files of a chunk, and what they cost."""

    games: bytes
    trajectories: bytes | None
    seconds: float  # of the clock
    cpu_seconds: float
    playing_seconds: float  # of the clock, without the making of tables


class OtherCodeError(Exception):
    """A worker has another version of covey than the one that leads the study."""


def play_chunk(study: Study, chunk: Chunk, code: str) -> Parts:
    """Play the games of a chunk."""
    if code_digest() != code:
        raise OtherCodeError("a worker has another version of covey; install the same everywhere")
    clock, cpu = time.perf_counter(), time.thread_time()
    games = [game for start in range(chunk.first, chunk.last) for game in play_start(study, start)]
    playing = time.perf_counter() - clock
    table = encoded(games_table(study, games))
    moments = encoded(moments_table(study, games)) if study.trajectories else None
    return Parts(table, moments, time.perf_counter() - clock, time.thread_time() - cpu, playing)
