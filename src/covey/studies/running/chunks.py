"""How a study is cut into chunks: consecutive starts, each chunk one file, whole or not at all."""

from __future__ import annotations

from dataclasses import dataclass

from covey.studies.design.study import Study

_MOST_GAMES, _LEAST_GAMES = 1000, 64
_MOST_RECORDS = 100  # of whole games, each some 100 kB, that a worker holds
_CHUNKS = 64


@dataclass(frozen=True)
class Chunk:
    """The starts from `first` up to `last`."""

    number: int
    first: int
    last: int


def starts_per_chunk(study: Study) -> int:
    """Return how many starts make a chunk; it depends on the study alone, never on the workers.

    A small study is cut into some 64 chunks, so that many workers have work until the end. Fewer
    games than 64 would not be worth a file, and more than 1000 too much to lose.
    """
    most = _MOST_RECORDS if study.trajectories else _MOST_GAMES
    games = min(max(study.games // _CHUNKS, _LEAST_GAMES), most)
    return max(1, games // len(study.cases))


def chunks_of(study: Study) -> list[Chunk]:
    """Return all chunks of a study."""
    step = starts_per_chunk(study)
    return [
        Chunk(number, first, min(first + step, study.starts))
        for number, first in enumerate(range(0, study.starts, step))
    ]
