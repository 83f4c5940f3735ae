"""One local maximum of what a team wants, whatever that is."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Pursuit, Table
from covey.kernels.capture.path import set_paths
from covey.kernels.capture.sequence import measured
from covey.kernels.maximum.expected_value import ascend_expected, expected_value
from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.sqp import AscentScratch, Tally, ascend
from covey.kernels.maximum.working_set import Columns
from covey.kernels.minimum.greedy_sequence import nearest_first, short_sequence
from covey.kernels.minimum.inner_minimum import least_value


@compiled
def climb(
    evaders: Table,
    pursuit: Pursuit,
    aim: Aim,
    turns: Floats,
    columns: Columns,
    box: float,
    tolerance: float,
    most_steps: int,
    known: float,
    scratch: AscentScratch,
) -> tuple[float, int, Tally]:
    """`ascend` or, without `columns` and what is `known`, `ascend_expected`."""
    if aim.expected:
        return ascend_expected(evaders, pursuit, aim, turns, box, tolerance, most_steps, scratch)
    return ascend(
        evaders,
        pursuit,
        aim.total,
        turns,
        columns,
        box,
        tolerance,
        most_steps,
        known,
        scratch,
    )


@compiled
def worth(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    turns: Floats,
    enough: float,
    scratch: AscentScratch,
) -> float:
    """What turns are worth, or -inf where one sequence shows that it isn't more than `enough`."""
    set_paths(evaders, turns[:n], pursuit.speed, scratch.here.paths)
    if aim.expected:
        return expected_value(scratch.here.paths, n, pursuit, aim, scratch.here.times[0])
    times = scratch.here.times[0]
    if aim.total:
        nearest_first(scratch.here.paths, n, pursuit, -1, scratch.found, times)
    else:
        short_sequence(scratch.here.paths, n, pursuit, scratch.found, times)
    bound = measured(times, n, aim.total)
    if bound <= enough:
        return -math.inf
    value, _ = least_value(
        scratch.here.paths, n, pursuit, aim.total, bound, scratch.found, scratch.worst
    )
    return value
