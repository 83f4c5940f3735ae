"""What is compared in a study with a first of its kind, from the same starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from covey.model.validation import Floats
from covey.studies.running.tables import described_text
from covey.studies.statistics import UNKNOWN, Z95, Estimate


class Score(NamedTuple):
    """A mean relative to that of the first of its kind: a cell of a table, a mark in a picture."""

    group: str  # a table, or a row of panels
    column: str
    row: str  # who or what is compared
    team_size: int | None  # None: the mean over all sizes
    relative: Estimate
    starts: int  # those whose games came to an end, its own and the first one's
    played: int  # all starts that were played


class Comparison(NamedTuple):
    """A study in scores."""

    rows: str  # what is compared, in a word
    base: str  # the first of its kind
    label: str  # what the scores are
    scores: list[Score]


def varies_alone(study: dict[str, Any], name: str, sides: Sequence[str]) -> bool:
    """Return whether something varies in a study, and nothing beside it but `sides`."""
    grid = study["grid"]
    others = [each for each in grid if each not in (name, *sides)]
    return len(grid[name]) > 1 and all(len(grid[each]) == 1 for each in others)


def scores_by_size(
    place: tuple[str, str, str], sizes: Sequence[int], own: Floats, first: Floats
) -> Iterator[Score]:
    """Return the scores of one group, column and row: each team size, and all sizes last.

    `own` and `first` (starts, sizes) are what the games came to. Starts are paired: each ratio of
    means, and the delta method's 95 % interval, comes from starts of which both games ended. The
    mean over the sizes takes those of which all did.
    """
    for k, size in enumerate(sizes):
        yield Score(*place, size, *_relative(own[:, [k]], first[:, [k]]), len(own))
    yield Score(*place, None, *_relative(own, first), len(own))


def labels(strategies: Sequence[dict[str, Any]]) -> list[str]:
    """Return the names, with their parameters where names alone don't tell them apart."""
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
