"""Every team against every pursuer: how long each survives, relative to the first team."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from covey.model.checks import Floats
from covey.studies.moments import UNKNOWN, Z95, Estimate
from covey.studies.results import StudyResult
from covey.studies.study import GRID
from covey.studies.table import described_text

_SIDES = ("team_size", "sensing", "evaders", "pursuer")


class Score(NamedTuple):
    """How long a team survives, relative to the first team of the study, against one pursuer."""

    sensing: str
    pursuer: str
    evaders: str
    team_size: int | None  # None: the mean over all sizes
    relative: Estimate  # mean survival time over that of the first team
    starts: int  # those whose games came to an end, its own and the first team's
    played: int  # all starts that were played


def is_tournament(study: dict[str, Any]) -> bool:
    """Return whether several teams of a study meet pursuers, and nothing else varies but size."""
    grid = study["grid"]
    others = [name for name in GRID if name not in _SIDES]
    return len(grid["evaders"]) > 1 and all(len(grid[name]) == 1 for name in others)


def scores(result: StudyResult) -> Iterator[Score]:
    """Return the scores of a tournament, for each sensing, pursuer and team; all sizes come last.

    Starts are paired: each ratio of means, and the delta method's 95 % interval, comes from starts
    of which both games ended. The mean over the sizes takes those of which all did.
    """
    grid = result.study["grid"]
    sizes: list[int] = grid["team_size"]
    evaders, pursuers = labels(grid["evaders"]), labels(grid["pursuer"])
    shape = [len(grid[name]) for name in _SIDES]
    parts = [part["survival_time"].to_numpy() for part in result.parts()]
    times = np.concatenate([np.empty(0), *parts]).reshape(-1, *shape)
    count = len(times)
    for (s, sensing), (p, pursuer), (e, team) in product(
        enumerate(grid["sensing"]), enumerate(pursuers), enumerate(evaders)
    ):
        own, first = times[:, :, s, e, p], times[:, :, s, 0, p]
        for k, size in enumerate(sizes):
            yield Score(sensing, pursuer, team, size, *_relative(own[:, [k]], first[:, [k]]), count)
        yield Score(sensing, pursuer, team, None, *_relative(own, first), count)


def labels(strategies: Sequence[dict[str, Any]]) -> list[str]:
    """Return the strategies' names, with their parameters where names alone don't tell them."""
    names = [strategy["name"] for strategy in strategies]
    return [
        name if names.count(name) == 1 else described_text(strategy)
        for name, strategy in zip(names, strategies, strict=True)
    ]


def _relative(own: Floats, first: Floats) -> tuple[Estimate, int]:
    """Mean over the sizes (columns) of the ratio of mean times (rows are starts)."""
    ended = np.isfinite(own + first).all(axis=1)
    own, first = own[ended], first[ended]
    count = len(own)
    if count < 2:
        return UNKNOWN, count
    mean = first.mean(axis=0)
    ratios = own.mean(axis=0) / mean
    # To first order, the mean of the ratios varies as the mean of this.
    part = ((own - ratios * first) / mean).mean(axis=1)
    error = Z95 * float(part.std(ddof=1)) / count**0.5
    return Estimate(float(ratios.mean()), error), count
