"""The best of several local maxima: screen many starts, follow the promising ones.

The guaranteed time has many local maxima, more as the team grows, so one ascent is not enough.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.ascent import AscentScratch, Columns, Tally, ascend, ascent_scratch, make_columns
from covey.kernels.path import HEADING, X, Y, set_paths, wrapped
from covey.kernels.subsets import least_time
from covey.kernels.types import Floats, Pursuit, Table

FIRST_BOX = 1.0
"""Largest first change of a turn, radians, in an ascent that starts from nowhere in particular."""


class SearchScratch(NamedTuple):
    """Arrays of a search among up to k starts for up to n evaders."""

    starts: Table  # (k, n)
    worths: Floats  # (k,) values of the starts, -inf once followed
    turns: Floats  # (n,)
    columns: Columns
    ascent: AscentScratch


@allocating
def search_scratch(k: int, n: int) -> SearchScratch:
    """Allocate the scratch of a search."""
    return SearchScratch(
        np.empty((k, n)), np.empty(k), np.empty(n), make_columns(n), ascent_scratch(n)
    )


@compiled
def lay_out_starts(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    noise: Table,
    warm: bool,
    turns: Floats,
    scratch: SearchScratch,
) -> int:
    """Write and evaluate the starts; return how many there are.

    The `turns` given if `warm`, then flight straight away from the disk's centre, then that flight
    turned by π times the rows of `noise` (numbers in [-1, 1]). The former come first whatever they
    are worth.
    """
    first = 1 if warm else 0
    count = first + 1 + len(noise)
    starts, worths = scratch.starts, scratch.worths
    for k in range(count):
        for i in range(n):
            if k < first:
                starts[k, i] = turns[i]
            else:
                off_x, off_y = evaders[i, X] - pursuit.center_x, evaders[i, Y] - pursuit.center_y
                swing = math.pi * noise[k - first - 1, i] if k > first else 0.0
                starts[k, i] = wrapped(math.atan2(off_y, off_x) + swing - evaders[i, HEADING])
        worths[k] = math.inf if k <= first else _worth(evaders, n, pursuit, starts[k], scratch)
    return count


@compiled
def follow_best_start(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    count: int,
    best: float,
    tolerance: float,
    most_steps: int,
    turns: Floats,
    columns: Columns,
    scratch: SearchScratch,
) -> tuple[bool, float, int, Tally]:
    """Ascend from the best of `count` starts that is left.

    Returns whether the value is clearly above `best` (-inf: none yet), and what `ascend` does; if
    it is, its turns and columns are written to `turns` and `columns`. Among equals the first one
    wins, so that a team doesn't change its mind for nothing.
    """
    starts, worths = scratch.starts, scratch.worths
    chosen = 0
    for k in range(count):
        if worths[k] > worths[chosen]:
            chosen = k
    worths[chosen] = -math.inf
    for i in range(n):
        scratch.turns[i] = starts[chosen, i]
    scratch.columns.used[0] = 0
    value, ended, tally = ascend(
        evaders,
        pursuit,
        scratch.turns[:n],
        scratch.columns,
        FIRST_BOX,
        tolerance,
        most_steps,
        scratch.ascent,
    )
    improved = value > best + 1e-10 * abs(best) or best == -math.inf
    if improved:
        for i in range(n):
            turns[i] = scratch.turns[i]
        copy_columns(scratch.columns, n, columns)
    return improved, value, ended, tally


@compiled
def copy_columns(source: Columns, n: int, target: Columns) -> None:
    """Copy the columns of n evaders."""
    target.used[0] = source.used[0]
    for s in range(source.used[0]):
        target.weights[s] = source.weights[s]
        for k in range(n):
            target.sequences[s, k] = source.sequences[s, k]


@compiled
def _worth(
    evaders: Table, n: int, pursuit: Pursuit, turns: Floats, scratch: SearchScratch
) -> float:
    """The exact value of a start."""
    ascent = scratch.ascent
    set_paths(evaders, turns[:n], pursuit.speed, ascent.paths)
    value, _ = least_time(
        ascent.paths,
        n,
        pursuit,
        math.inf,
        ascent.labels,
        ascent.arrivals,
        ascent.members,
        ascent.found,
    )
    return value
