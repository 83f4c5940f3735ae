"""One local maximum of a mean over capture sequences that are drawn: Newton's method in a box.

No least is taken, so the mean is as smooth as a capture time: its gradient is continuous, and its
curvature too unless somebody is captured at the very end of a turn.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Pursuit, Table
from covey.kernels.capture.path import set_paths
from covey.kernels.capture.sequence import add_curvature, capture_times, differentiate, measured
from covey.kernels.maximum.curvature import shape, take_way, ways_off
from covey.kernels.maximum.local_model import ModelScratch, best_step, unit_of
from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.sqp import (
    CONVERGED,
    LEAST_BOX,
    STALLED,
    STEPS_USED_UP,
    AscentScratch,
    Tally,
    resized,
)


@compiled
def expected_value(paths: Table, n: int, pursuit: Pursuit, aim: Aim, times: Floats) -> float:
    """The mean; `times` (n,) is scratch."""
    value = 0.0
    for s in range(aim.draws.used[0]):
        capture_times(paths, pursuit, aim.draws.sequences[s, :n], times)
        value += aim.draws.weights[s] * measured(times, n, aim.total)
    return value


@compiled
def ascend_expected(
    evaders: Table,
    pursuit: Pursuit,
    aim: Aim,
    turns: Floats,
    box: float,
    tolerance: float,
    most_steps: int,
    scratch: AscentScratch,
) -> tuple[float, int, Tally]:
    """Improve `turns` in place to a local maximum; return its value, how it ended, the cost.

    As `ascend`, which see, with one model in place of several, and nothing known beforehand.
    """
    n, drawn = len(turns), aim.draws.used[0]
    paths, times, model = scratch.here.paths, scratch.here.times[0], scratch.model
    set_paths(evaders, turns, pursuit.speed, paths)
    value = expected_value(paths, n, pursuit, aim, times)
    interceptions, steps, ended = n * drawn, 0, STEPS_USED_UP
    moved, unit = True, 1.0
    while steps < most_steps:
        if moved:
            unit = unit_of(value)
            _linearise(paths, n, pursuit, aim, unit, times, model)
            shape(n, scratch.one, scratch.here.values, False, unit, model)
        scratch.here.values[0] = value
        promise = best_step(turns, n, scratch.one, scratch.here.values, box, unit, model)
        if promise - value <= tolerance * value:
            promise = _way_off_a_saddle(evaders, n, pursuit, aim, turns, unit, scratch)
            if promise - value <= 2.0 * tolerance * value:
                ended = CONVERGED
                break
        steps += 1
        trial = _try_step(evaders, n, pursuit, aim, turns, scratch)
        interceptions += n * drawn
        gained = (trial - value) / (promise - value)
        longest = 0.0
        for i in range(n):
            longest = max(longest, abs(scratch.turns[i] - turns[i]))
        moved = gained > 0.0
        if moved:
            value = trial
            for i in range(n):
                turns[i] = scratch.turns[i]
            set_paths(evaders, turns, pursuit.speed, paths)
        box = resized(box, gained, longest)
        if box < LEAST_BOX:
            ended = STALLED
            break
    return value, ended, Tally(steps, 0, interceptions)


@compiled
def _try_step(
    evaders: Table, n: int, pursuit: Pursuit, aim: Aim, turns: Floats, scratch: AscentScratch
) -> float:
    """Move `turns` by the step; return the mean there."""
    for i in range(n):
        scratch.turns[i] = min(max(turns[i] + scratch.model.step[i], -math.pi), math.pi)
    set_paths(evaders, scratch.turns[:n], pursuit.speed, scratch.there.paths)
    return expected_value(scratch.there.paths, n, pursuit, aim, scratch.there.times[0])


@compiled
def _way_off_a_saddle(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    turns: Floats,
    unit: float,
    scratch: AscentScratch,
) -> float:
    """Write the step that leads highest off a saddle or a plateau; return the mean there.

    -inf if everything bends downwards.
    """
    best, highest = -1, -math.inf
    for way in range(ways_off(n, scratch.one, scratch.here.values, unit, scratch.model)):
        take_way(way, n, scratch.model)
        reached = _try_step(evaders, n, pursuit, aim, turns, scratch)
        if reached > highest:
            best, highest = way, reached
    take_way(best, n, scratch.model)
    return highest


@compiled
def _linearise(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    unit: float,
    times: Floats,
    model: ModelScratch,
) -> None:
    """Gradient and curvature, its sign turned, of the mean, as those of the only column."""
    mean, own, curvature = model.gradients[0], model.gradients[1], model.curvature
    for i in range(n):
        mean[i] = 0.0
        for j in range(n):
            curvature[i, j] = 0.0
    for s in range(aim.draws.used[0]):
        sequence, share = aim.draws.sequences[s, :n], unit * aim.draws.weights[s]
        capture_times(paths, pursuit, sequence, times)
        differentiate(paths, pursuit, sequence, aim.total, times, model.captures, own)
        for i in range(n):
            mean[i] += share * own[i]
        add_curvature(
            paths, pursuit, sequence, times, model.captures, -share, model.slopes, curvature
        )
