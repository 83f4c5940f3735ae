"""How a study is cut into chunks of consecutive starts. Each chunk becomes one file."""

from __future__ import annotations

from dataclasses import dataclass

from covey.studies.design.study import Study

_MAX_GAMES, _MIN_GAMES = 1000, 64
_MAX_RECORDS = 100
"""Whole games that a worker holds when trajectories are stored; each takes some 100 kB."""

_CHUNKS = 64


@dataclass(frozen=True)
class Chunk:
    """The starts from `first` up to, but without, `last`."""

    number: int
    first: int
    last: int


def starts_per_chunk(study: Study) -> int:
    """Return how many starts make a chunk. The number depends on the study, never on the workers.

    A small study is cut into some 64 chunks, so that many workers have work until the end. Fewer
    than 64 games are not worth a file. More than 1000 games are too much to lose.
    """
    most = _MAX_RECORDS if study.trajectories else _MAX_GAMES
    games = min(max(study.games // _CHUNKS, _MIN_GAMES), most)
    return max(1, games // len(study.cases))


def chunks_of(study: Study) -> list[Chunk]:
    """Return all chunks of a study."""
    step = starts_per_chunk(study)
    return [
        Chunk(number, first, min(first + step, study.starts))
        for number, first in enumerate(range(0, study.starts, step))
    ]
