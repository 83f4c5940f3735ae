"""Ratios of means from the same starts: each team, or objective, over the first of its study."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from covey.model.validation import Floats
from covey.studies.statistics import UNKNOWN, Z95, Estimate


class PairedRatio(NamedTuple):
    """A mean over that of the reference: a cell of a table, a mark in a picture."""

    group: str  # a table, or a row of panels
    column: str
    row: str  # the team or objective that is compared
    team_size: int | None  # None: the mean over all sizes
    relative: Estimate
    starts: int  # those of which both games ended
    played: int  # all starts that were played


class Comparison(NamedTuple):
    """A study as ratios."""

    rows: str  # what is compared, in a word
    base: str  # the row of the reference
    label: str  # what the ratios are
    ratios: list[PairedRatio]


def varies_alone(study: dict[str, Any], name: str, sides: Sequence[str]) -> bool:
    """Return whether a field of the grid varies in a study, and no other field but `sides`."""
    grid = study["grid"]
    others = [each for each in grid if each not in (name, *sides)]
    return len(grid[name]) > 1 and all(len(grid[each]) == 1 for each in others)


def ratios_by_size(
    cell: tuple[str, str, str], sizes: Sequence[int], own: Floats, reference: Floats
) -> Iterator[PairedRatio]:
    """Return the ratios of one group, column and row: one for each team size, then their mean.

    Each ratio is over the starts of which both games ended; the mean over the sizes is over the
    starts of which all games ended. Intervals are the delta method's for paired samples, 95 %.

    Parameters
    ----------
    cell
        Group, column and row.
    sizes
        The S team sizes.
    own, reference
        (starts, S) values of the games that are compared; inf where a game was stopped.
    """
    for k, size in enumerate(sizes):
        yield PairedRatio(*cell, size, *_mean_ratio(own[:, [k]], reference[:, [k]]), len(own))
    yield PairedRatio(*cell, None, *_mean_ratio(own, reference), len(own))


def _mean_ratio(own: Floats, reference: Floats) -> tuple[Estimate, int]:
    """Mean over the sizes (columns) of the ratio of means over the starts (rows), and the count."""
    ended = np.isfinite(own + reference).all(axis=1)
    own, reference = own[ended], reference[ended]
    count = len(own)
    if count < 2:
        return UNKNOWN, count
    mean = reference.mean(axis=0)
    ratios = own.mean(axis=0) / mean
    # To first order the mean of the ratios varies as the mean of these deviations.
    deviations = ((own - ratios * reference) / mean).mean(axis=1)
    error = Z95 * float(deviations.std(ddof=1)) / count**0.5
    return Estimate(float(ratios.mean()), error), count
