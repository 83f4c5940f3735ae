"""One local maximum of the guaranteed survival time (eq. 6), by sequential quadratic programming.

Column generation: only a few sequences, the columns, are carried along; at every trial point the
search for the worst sequence says exactly whether another sequence is worse, and that one joins.
A step is the best of the local model inside a box that shrinks when a step disappoints.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.path import set_paths
from covey.kernels.maximum.curvature import drifted, shape, take_way, ways_off
from covey.kernels.maximum.local_model import (
    ModelScratch,
    best_step,
    corrected_step,
    linearise,
    linearise_one,
    model_scratch,
    unit_of,
)
from covey.kernels.maximum.working_set import (
    Columns,
    Point,
    evaluate,
    evaluate_one,
    join,
    make_columns,
    make_point,
)
from covey.kernels.minimum.inner_minimum import WorstScratch, least_value, worst_scratch

CONVERGED, STALLED, STEPS_USED_UP = range(3)

LEAST_BOX = 1e-9
"""An ascent ends when it may change turns by no more."""

_MOST_CORRECTIONS = 3
_ROUNDING, _REFUTED = 1e-12, 1e-9
_DISAPPOINTING = 0.8  # share of the promise below which a step is corrected


class AscentScratch(NamedTuple):
    """Arrays of an ascent with n evaders and up to m columns."""

    here: Point
    there: Point  # of the trial
    turns: Floats  # (n,) of the trial
    first_turns: Floats  # (n,) of the trial before its correction
    found: Ints  # (n,) the sequence that the search for the worst found
    worst: WorstScratch
    model: ModelScratch
    one: Columns  # a single column, which stands for a mean


class Tally(NamedTuple):
    """What an ascent cost."""

    steps: int
    programmes: int
    interceptions: int


@allocating
def ascent_scratch(n: int, total: bool = False) -> AscentScratch:
    """Allocate the scratch of `ascend` for teams of up to n."""
    one = make_columns(n)
    one.used[0], one.weights[0] = 1, 1.0
    return AscentScratch(
        make_point(n),
        make_point(n),
        np.empty(n),
        np.empty(n),
        np.empty(n, np.int64),
        worst_scratch(n, total),
        model_scratch(n),
        one,
    )


@compiled
def ascend(
    evaders: Table,
    pursuit: Pursuit,
    total: bool,
    turns: Floats,
    columns: Columns,
    box: float,
    tolerance: float,
    most_steps: int,
    known: float,
    scratch: AscentScratch,
) -> tuple[float, int, Tally]:
    """Improve `turns` in place to a local maximum; return its exact value, how it ended, the cost.

    The value, the least over all sequences of the last capture or of the `total`, never falls below
    that of the turns given. `box` is the largest first change of a turn; the ascent has converged
    when the model promises less than `tolerance`, relative. The turns are `known` to be worth so
    much at least (-inf: nothing is known), unless a column refutes it, as where the last plan was
    not flown. Where a column says that they aren't worth more, the worst sequence needn't be
    searched. Nor need it be where a step leads to turns that are worth more than the columns before
    it. A step whose promise came true to `tolerance` is the last: what the next would gain is less
    than what the model was wrong by. One that was straightened, or has the curvature of columns
    that the step leaves alone, may be too stiff: it is trusted only where something is known.
    """
    n = len(turns)
    here, there = scratch.here, scratch.there
    set_paths(evaders, turns, pursuit.speed, here.paths)
    value = evaluate(here, n, pursuit, total, columns)
    programmes = interceptions = steps = 0
    ended = STEPS_USED_UP
    if value < known * (1.0 - _REFUTED):
        known = -math.inf
    settled = value <= known * (1.0 + _ROUNDING)
    if settled:
        value = known
    exact = settled  # if not, the value is that of the columns, and may be less
    if columns.used[0] == 0:
        value, _, interceptions = _exact_value(here, n, pursuit, total, columns, value, scratch)
        programmes, exact = 1, True
    straightened, mended, unit = False, False, 1.0
    moved, looked = True, False  # gradients and curvature belong to other turns, to these weights
    while steps < most_steps:
        if moved:
            unit = unit_of(value)
            linearise(here, n, pursuit, total, columns, unit, scratch.model)
            straightened, mended = shape(n, columns, here.values, True, unit, scratch.model)
        promise = best_step(turns, n, columns, here.values, box, unit, scratch.model)
        if straightened and promise - value <= tolerance * value:
            straightened, mended = shape(n, columns, here.values, False, unit, scratch.model)
            promise = best_step(turns, n, columns, here.values, box, unit, scratch.model)
        if promise - value <= tolerance * value:
            if not exact:
                value, joined, cost = _exact_value(here, n, pursuit, total, columns, value, scratch)
                programmes += 1
                interceptions += cost
                exact = moved = True
                if joined >= 0:
                    continue
            if settled and steps == 0:  # it was no saddle when it was found
                ended = CONVERGED
                break
            if not looked and drifted(columns, scratch.model):
                looked = moved = True
                continue
            promise = _way_off_a_saddle(
                evaders, n, pursuit, total, turns, columns, here, unit, there, scratch
            )
            if promise - value <= 2.0 * tolerance * value:
                ended = CONVERGED
                break
        steps += 1
        trial, value, asked, cost = _step_and_correct(
            evaders,
            n,
            pursuit,
            total,
            turns,
            columns,
            value,
            exact,
            promise,
            box,
            unit,
            here,
            there,
            scratch,
        )
        programmes += asked
        interceptions += cost
        gained = (trial - value) / (promise - value)
        longest = 0.0
        for i in range(n):
            longest = max(longest, abs(scratch.turns[i] - turns[i]))
        moved = gained > 0.0
        if moved:
            value, exact = trial, True
            for i in range(n):
                turns[i] = scratch.turns[i]
            here, there = there, here
            came_true = longest < box and abs(trial - promise) <= tolerance * value
            trusted = known > -math.inf or not (straightened or drifted(columns, scratch.model))
            if came_true and trusted and not mended:
                ended = CONVERGED
                break
            looked = False
        box = resized(box, gained, longest)
        if box < LEAST_BOX:
            ended = STALLED
            break
    if not exact:
        value, _, cost = _exact_value(here, n, pursuit, total, columns, value, scratch)
        programmes += 1
        interceptions += cost
    return value, ended, Tally(steps, programmes, interceptions)


@inlined
def _step_and_correct(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    total: bool,
    turns: Floats,
    columns: Columns,
    value: float,
    exact: bool,
    promise: float,
    box: float,
    unit: float,
    here: Point,
    there: Point,
    scratch: AscentScratch,
) -> tuple[float, float, int, int]:
    """Try the step; correct it where it disappoints, also by columns that join because of it.

    Returns the value there, which is exact if it is above that where the step began; the latter,
    which a column that joins may lower unless it is `exact`; programmes and interceptions.
    """
    trial = _try_step(evaders, n, pursuit, total, turns, columns, there, scratch)
    programmes = interceptions = 0
    for _ in range(_MOST_CORRECTIONS):
        if columns.used[0] > 1 and trial - value < _DISAPPOINTING * (promise - value):
            bar = max(trial, value)
            trial = _correct(
                evaders, n, pursuit, total, turns, columns, bar, box, unit, there, scratch
            )
        if trial <= value:
            break
        trial, joined, cost = _exact_value(there, n, pursuit, total, columns, trial, scratch)
        programmes += 1
        interceptions += cost
        if joined < 0:
            break
        joined_value = evaluate_one(here, n, pursuit, total, columns, joined)
        linearise_one(here, n, pursuit, total, columns, joined, unit, scratch.model)
        if not exact:
            value = min(value, joined_value)
        if trial > value:
            break
    return trial, value, programmes, interceptions


@inlined
def resized(box: float, gained: float, longest: float) -> float:
    """The box of the next step, after one that changed a turn by at most `longest`.

    It `gained` such a share of what was promised.
    """
    if gained < 0.25:
        return (0.7 if gained > -1.0 else 0.35) * longest
    if gained > 0.7:
        return min(max(box, 1.5 * longest), math.pi)
    return box


@compiled
def _try_step(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    total: bool,
    turns: Floats,
    columns: Columns,
    there: Point,
    scratch: AscentScratch,
) -> float:
    """Move `turns` by the step; return the least of the columns there, no less than the value."""
    for i in range(n):
        scratch.turns[i] = min(max(turns[i] + scratch.model.step[i], -math.pi), math.pi)
    set_paths(evaders, scratch.turns[:n], pursuit.speed, there.paths)
    return evaluate(there, n, pursuit, total, columns)


@compiled
def _correct(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    total: bool,
    turns: Floats,
    columns: Columns,
    bar: float,
    box: float,
    unit: float,
    there: Point,
    scratch: AscentScratch,
) -> float:
    """Replace a trial that disappoints by its second-order correction, if that is above the bar."""
    for i in range(n):
        scratch.first_turns[i] = scratch.turns[i]
    corrected_step(turns, scratch.turns, n, columns, there.values, box, unit, scratch.model)
    second = _try_step(evaders, n, pursuit, total, turns, columns, there, scratch)
    if second > bar:
        return second
    for i in range(n):
        scratch.turns[i] = scratch.first_turns[i]
    set_paths(evaders, scratch.turns[:n], pursuit.speed, there.paths)
    return evaluate(there, n, pursuit, total, columns)


@compiled
def _exact_value(
    point: Point,
    n: int,
    pursuit: Pursuit,
    total: bool,
    columns: Columns,
    bound: float,
    scratch: AscentScratch,
) -> tuple[float, int, int]:
    """The exact minimum over all sequences, where `bound` is the least of the columns.

    Returns also the column that joined because it is below the bound, or -1, and the cost.
    """
    least, interceptions = least_value(
        point.paths, n, pursuit, total, bound, scratch.found, scratch.worst
    )
    joined = -1
    if least < bound:
        joined = join(columns, n, scratch.found, point.values)
        evaluate_one(point, n, pursuit, total, columns, joined)
    return least, joined, interceptions


@compiled
def _way_off_a_saddle(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    total: bool,
    turns: Floats,
    columns: Columns,
    here: Point,
    unit: float,
    there: Point,
    scratch: AscentScratch,
) -> float:
    """Write the step that leads highest off a saddle or a plateau; return what the columns reach.

    Where no gradient is left the ascent may stand on one. -inf if everything bends downwards.
    """
    best, highest = -1, -math.inf
    for way in range(ways_off(n, columns, here.values, unit, scratch.model)):
        take_way(way, n, scratch.model)
        reached = _try_step(evaders, n, pursuit, total, turns, columns, there, scratch)
        if reached > highest:
            best, highest = way, reached
    take_way(best, n, scratch.model)
    return highest
