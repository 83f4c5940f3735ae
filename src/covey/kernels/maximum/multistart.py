"""The best of several local maxima: ascents from many starts.

The guaranteed time has many local maxima, more as the team grows, so one ascent is not enough.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Pursuit, Table
from covey.kernels.capture.path import set_paths
from covey.kernels.maximum.initial_guesses import BATCH, Elite, enter, lay_out, make_elite
from covey.kernels.maximum.local_maximum import climb
from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.sqp import AscentScratch, Tally, ascent_scratch
from covey.kernels.maximum.working_set import Columns, copy_columns, evaluate, make_columns

FIRST_BOX = 0.6
"""Largest first change of a turn, radians, in an ascent that starts from nowhere in particular."""

WARM_BOX = 0.2
"""The same in an ascent that starts from a plan of a moment ago."""

BARE_BOX = 0.02
"""The same from turns whose sequences nobody knows: until they are met, longer steps may leap from
a maximum to another one."""


class SearchScratch(NamedTuple):
    """Arrays of a search for up to n evaders."""

    candidate: Floats  # (n,)
    turns: Floats  # (n,)
    columns: Columns
    batch: Elite  # (BATCH,) what the present batch came to
    elite: Elite
    ascent: AscentScratch


@allocating
def search_scratch(n: int, total: bool = False) -> SearchScratch:
    """Allocate the scratch of a search."""
    return SearchScratch(
        np.empty(n),
        np.empty(n),
        make_columns(n),
        Elite(np.empty(BATCH), np.empty((BATCH, n))),
        make_elite(n),
        ascent_scratch(n, total),
    )


@compiled
def search(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    noise: Table,
    count: int,
    best: float,
    tolerance: float,
    most_steps: int,
    turns: Floats,
    columns: Columns,
    elite: Elite,
    scratch: SearchScratch,
) -> tuple[float, int, Tally]:
    """Ascend from `count` starts.

    Returns the best value, at least `best` (-inf: none yet), how its ascent ended, and the cost.
    Where a start comes out clearly above `best`, its turns and columns are written to `turns` and
    `columns`. Among equals the first one wins, so that a team doesn't change its mind for nothing.
    """
    ended, total = 0, Tally(0, 0, 0)
    for start in range(count):
        value, how, cost = follow(
            evaders, n, pursuit, aim, noise, start, tolerance, most_steps, elite, scratch
        )
        total = added(total, cost)
        if is_better(value, best):
            best, ended = value, how
            for i in range(n):
                turns[i] = scratch.turns[i]
            copy_columns(scratch.columns, n, columns)
        scratch.batch.values[start % BATCH] = value
        for i in range(n):
            scratch.batch.turns[start % BATCH, i] = scratch.turns[i]
        if start % BATCH == BATCH - 1:
            for k in range(BATCH):
                enter(elite, n, scratch.batch.values[k], scratch.batch.turns[k])
    return best, ended, total


@inlined
def added(one: Tally, other: Tally) -> Tally:
    """Add up what two ascents cost."""
    return Tally(
        one.steps + other.steps,
        one.programmes + other.programmes,
        one.interceptions + other.interceptions,
    )


@compiled
def is_better(value: float, best: float) -> bool:
    """Whether a plan is clearly better than the best one so far (-inf: there is none)."""
    return value > best + 1e-10 * abs(best) or best == -math.inf


@compiled
def follow(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    noise: Table,
    start: int,
    tolerance: float,
    most_steps: int,
    elite: Elite,
    scratch: SearchScratch,
) -> tuple[float, int, Tally]:
    """Ascend from one start, to `scratch.turns` and `scratch.columns`."""
    lay_out(
        evaders,
        n,
        pursuit,
        aim,
        noise,
        start,
        elite,
        scratch.candidate,
        scratch.turns,
        scratch.ascent,
    )
    scratch.columns.used[0] = 0
    return climb(
        evaders,
        pursuit,
        aim,
        scratch.turns[:n],
        scratch.columns,
        FIRST_BOX,
        tolerance,
        most_steps,
        -math.inf,
        scratch.ascent,
    )


class Found(NamedTuple):
    """The plan that a search came to."""

    value: float
    ended: int
    cost: Tally
    turns: Floats  # (n,)
    columns: Columns
    values: Floats  # what each column comes to; of no use where a mean is taken


@allocating
def continue_plan(
    evaders: Table,
    pursuit: Pursuit,
    aim: Aim,
    turns: Floats,
    columns: Columns,
    tolerance: float,
    most_steps: int,
) -> Found:
    """Ascend from `turns` and `columns`, which are overwritten."""
    scratch = ascent_scratch(len(turns), aim.total)
    box = WARM_BOX if columns.used[0] > 0 else BARE_BOX
    value, ended, cost = climb(
        evaders, pursuit, aim, turns, columns, box, tolerance, most_steps, -math.inf, scratch
    )
    return _found(evaders, pursuit, aim, value, ended, cost, turns, columns, scratch)


@allocating
def search_all(
    evaders: Table,
    pursuit: Pursuit,
    aim: Aim,
    noise: Table,
    count: int,
    tolerance: float,
    most_steps: int,
    elite: Elite,
) -> Found:
    """`search`, with scratch of its own."""
    n = len(evaders)
    turns, columns, scratch = np.zeros(n), make_columns(n), search_scratch(n, aim.total)
    value, ended, cost = search(
        evaders,
        n,
        pursuit,
        aim,
        noise,
        count,
        -math.inf,
        tolerance,
        most_steps,
        turns,
        columns,
        elite,
        scratch,
    )
    return _found(evaders, pursuit, aim, value, ended, cost, turns, columns, scratch.ascent)


@allocating
def follow_one(
    evaders: Table,
    pursuit: Pursuit,
    aim: Aim,
    noise: Table,
    start: int,
    tolerance: float,
    most_steps: int,
    elite: Elite,
) -> Found:
    """`follow`, with scratch of its own."""
    n = len(evaders)
    scratch = search_scratch(n, aim.total)
    value, ended, cost = follow(
        evaders, n, pursuit, aim, noise, start, tolerance, most_steps, elite, scratch
    )
    turns, columns = scratch.turns, scratch.columns
    return _found(evaders, pursuit, aim, value, ended, cost, turns, columns, scratch.ascent)


@allocating
def _found(
    evaders: Table,
    pursuit: Pursuit,
    aim: Aim,
    value: float,
    ended: int,
    cost: Tally,
    turns: Floats,
    columns: Columns,
    scratch: AscentScratch,
) -> Found:
    """What was found, with what each column comes to."""
    set_paths(evaders, turns, pursuit.speed, scratch.here.paths)
    evaluate(scratch.here, len(turns), pursuit, aim.total, columns)
    values = scratch.here.values[: columns.used[0]].copy()
    return Found(value, ended, cost, turns, columns, values)
