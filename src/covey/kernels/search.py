"""The best of several local maxima: ascents from many starts.

The guaranteed time has many local maxima, more as the team grows, so one ascent is not enough.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.ascent import AscentScratch, Tally, ascend, ascent_scratch
from covey.kernels.columns import Columns, copy_columns, make_columns
from covey.kernels.path import HEADING, TURN_RATE, X, Y, set_paths, wrapped
from covey.kernels.sequence import capture_times
from covey.kernels.subsets import least_time, nearest_first
from covey.kernels.types import Floats, Pursuit, Table

FIRST_BOX = 1.0
"""Largest first change of a turn, radians, in an ascent that starts from nowhere in particular."""

WARM_BOX = 0.2
"""The same in an ascent that starts from a plan of a moment ago."""

CANDIDATES = 8
"""Random turns that are evaluated for each start; the ascent begins at the best of them."""


class SearchScratch(NamedTuple):
    """Arrays of a search for up to n evaders."""

    candidate: Floats  # (n,)
    turns: Floats  # (n,)
    columns: Columns
    ascent: AscentScratch


@allocating
def search_scratch(n: int) -> SearchScratch:
    """Allocate the scratch of a search."""
    return SearchScratch(np.empty(n), np.empty(n), make_columns(n), ascent_scratch(n))


@compiled
def search(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    noise: Table,
    first: int,
    last: int,
    best: float,
    tolerance: float,
    most_steps: int,
    turns: Floats,
    columns: Columns,
    scratch: SearchScratch,
) -> tuple[float, int, Tally]:
    """Ascend from the starts numbered `first` to `last` - 1.

    Start 0 is flight straight away from the disk's centre; each of the others the best of that
    flight turned by π times `CANDIDATES` rows of `noise` (numbers in [-1, 1]).

    Returns the best value, at least `best` (-inf: none yet), how its ascent ended, and the cost.
    Where a start comes out clearly above `best`, its turns and columns are written to `turns` and
    `columns`. Among equals the first one wins, so that a team doesn't change its mind for nothing.
    """
    ended, steps, programmes, interceptions = 0, 0, 0, 0
    for start in range(first, last):
        _lay_out(evaders, n, pursuit, noise, start, scratch)
        scratch.columns.used[0] = 0
        value, how, cost = ascend(
            evaders,
            pursuit,
            scratch.turns[:n],
            scratch.columns,
            FIRST_BOX,
            tolerance,
            most_steps,
            -math.inf,
            scratch.ascent,
        )
        steps += cost.steps
        programmes += cost.programmes
        interceptions += cost.interceptions
        if value > best + 1e-10 * abs(best) or best == -math.inf:
            best, ended = value, how
            for i in range(n):
                turns[i] = scratch.turns[i]
            copy_columns(scratch.columns, n, columns)
    return best, ended, Tally(steps, programmes, interceptions)


@allocating
def search_once(
    evaders: Table,
    pursuit: Pursuit,
    noise: Table,
    warm: bool,
    first: int,
    last: int,
    best: float,
    tolerance: float,
    most_steps: int,
    turns: Floats,
    columns: Columns,
) -> tuple[float, int, Tally, Floats]:
    """Ascend from `turns` and `columns` if `warm`, and `search`, with scratch of its own.

    Returns also when each column of the best turns ends.
    """
    n, scratch = len(turns), search_scratch(len(turns))
    ended, tally = 0, Tally(0, 0, 0)
    if warm:
        best, ended, tally = ascend(
            evaders,
            pursuit,
            turns,
            columns,
            WARM_BOX,
            tolerance,
            most_steps,
            -math.inf,
            scratch.ascent,
        )
    found, how, cost = search(
        evaders,
        n,
        pursuit,
        noise,
        first,
        last,
        best,
        tolerance,
        most_steps,
        turns,
        columns,
        scratch,
    )
    if found > best:
        best, ended = found, how
    tally = Tally(
        tally.steps + cost.steps,
        tally.programmes + cost.programmes,
        tally.interceptions + cost.interceptions,
    )
    paths, times, ends = scratch.ascent.paths, scratch.ascent.times[0], np.empty(columns.used[0])
    set_paths(evaders, turns, pursuit.speed, paths)
    for s in range(len(ends)):
        ends[s] = capture_times(paths, pursuit, columns.sequences[s], times)
    return best, ended, tally, ends


@compiled
def _lay_out(
    evaders: Table, n: int, pursuit: Pursuit, noise: Table, start: int, scratch: SearchScratch
) -> None:
    """Write the turns of a start to `scratch.turns`."""
    if start == 0:
        _away(evaders, n, pursuit, scratch.turns)
        return
    best = -math.inf
    for row in range((start - 1) * CANDIDATES, start * CANDIDATES):
        _away(evaders, n, pursuit, scratch.candidate)
        for i in range(n):
            if evaders[i, TURN_RATE] > 0.0:
                scratch.candidate[i] = wrapped(scratch.candidate[i] + math.pi * noise[row, i])
        worth = _worth(evaders, n, pursuit, scratch.candidate, best, scratch.ascent)
        if worth > best:
            best = worth
            for i in range(n):
                scratch.turns[i] = scratch.candidate[i]


@compiled
def _away(evaders: Table, n: int, pursuit: Pursuit, turns: Floats) -> None:
    """Write the turns, the shorter way, to flight straight away from the disk's centre.

    An evader that can't turn keeps its heading here and in every start, for nothing depends on it.
    """
    for i in range(n):
        off_x, off_y = evaders[i, X] - pursuit.center_x, evaders[i, Y] - pursuit.center_y
        turns[i] = 0.0
        if evaders[i, TURN_RATE] > 0.0:
            turns[i] = wrapped(math.atan2(off_y, off_x) - evaders[i, HEADING])


@compiled
def _worth(
    evaders: Table, n: int, pursuit: Pursuit, turns: Floats, enough: float, scratch: AscentScratch
) -> float:
    """The exact value of a candidate, or -inf where one sequence shows that it isn't `enough`."""
    set_paths(evaders, turns[:n], pursuit.speed, scratch.paths)
    bound = nearest_first(scratch.paths, n, pursuit)
    if bound <= enough:
        return -math.inf
    value, _ = least_time(scratch.paths, n, pursuit, bound, scratch.found, scratch.subsets)
    return value
