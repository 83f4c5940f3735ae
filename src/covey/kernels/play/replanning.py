"""How an iterative open-loop team plans again, and how a committed pursuer keeps its sequence.

Both are kernels on the living only, so that a compiled game and a game with strategies in Python
run the same code.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.sequence import capture_times, measured
from covey.kernels.maximum.initial_guesses import enter
from covey.kernels.maximum.local_maximum import climb
from covey.kernels.maximum.multistart import WARM_BOX, SearchScratch, search
from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.sqp import AscentScratch
from covey.kernels.maximum.working_set import Columns
from covey.kernels.minimum.inner_minimum import least_value

MOST_STEPS = 8
"""Steps of an update that goes on from the last plan."""


@compiled
def replan(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    noise: Table,
    followed: int,
    tolerance: float,
    most_steps: int,
    known: float,
    turns: Floats,
    columns: Columns,
    scratch: SearchScratch,
) -> float:
    """Improve the `turns` that are flown, from them and `followed` other starts; return the value.

    Never worse than the turns given, which are `known` to be worth so much at least: what the last
    plan was worth, less the time since, whatever a pursuer did that keeps to the rules. An update
    without other starts is short: what it leaves undone the next one does.
    """
    value, _, _ = climb(
        evaders,
        pursuit,
        aim,
        turns[:n],
        columns,
        WARM_BOX,
        tolerance,
        min(most_steps, MOST_STEPS) if followed == 0 else most_steps,
        known,
        scratch.ascent,
    )
    if followed > 0:
        for k in range(len(scratch.elite.values)):
            scratch.elite.values[k] = -math.inf
        enter(scratch.elite, n, value, turns)
        value, _, _ = search(
            evaders,
            n,
            pursuit,
            aim,
            noise,
            followed,
            value,
            tolerance,
            most_steps,
            turns,
            columns,
            scratch.elite,
            scratch,
        )
    return value


@compiled
def commit(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    total: bool,
    margin: float,
    known: bool,
    sequence: Ints,
    times: Floats,
    scratch: AscentScratch,
) -> None:
    """Replace the `sequence` a pursuer follows where another is better by more than `margin`.

    Better is an earlier last capture or a smaller `total`. The margin is relative to what the one
    followed still comes to; inf keeps it for ever.
    Where none is `known` yet, the best is taken.
    """
    bound = math.inf
    if known:
        capture_times(paths, pursuit, sequence[:n], times)
        bound = measured(times, n, total) * (1.0 - margin)
    if bound > 0.0:
        least_value(paths, n, pursuit, total, bound, sequence, scratch.worst)
