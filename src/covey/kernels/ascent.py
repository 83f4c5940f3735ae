"""One local maximum of the guaranteed survival time (eq. 6), by sequential quadratic programming.

Column generation: only a few sequences, the *columns*, are carried along; at every trial point the
dynamic programme over subsets says exactly whether another sequence is worse, and that one joins.
A step maximises the least of the columns' linear models under the exact curvature of their
Lagrangian, inside a box that shrinks when a step disappoints.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.definite import diagonalise, factorise, make_positive
from covey.kernels.path import PATH, set_paths
from covey.kernels.quadratic import (
    QuadraticScratch,
    quadratic_scratch,
    solve_quadratic,
)
from covey.kernels.sequence import CAPTURE, add_curvature, capture_times, differentiate
from covey.kernels.subsets import SubsetScratch, least_time, subset_scratch
from covey.kernels.types import Floats, Ints, Pursuit, Table

CONVERGED, STALLED, STEPS_USED_UP = range(3)

_LEAST_BOX = 1e-9
_PENALTY = 20.0  # of the curvature, across the active columns
_STRIDE = 0.03  # radians, off a saddle
_MOST_CORRECTIONS = 3
_DISAPPOINTING = 0.6  # share of the promise below which a step is corrected


class Columns(NamedTuple):
    """The sequences that matter, kept from one ascent to the next: first `used[0]` rows."""

    used: Ints  # (1,) how many rows
    sequences: Ints  # (m, n)
    weights: Floats  # (m,) multipliers of the last step: the sequences' shares in its curvature


class AscentScratch(NamedTuple):
    """Arrays of an ascent with n evaders and up to m columns."""

    paths: Table  # (n, PATH)
    trial_paths: Table  # (n, PATH)
    turns: Floats  # (n,) of the trial
    first_turns: Floats  # (n,) of the trial before its correction
    times: Floats  # (m, n) capture times of each column
    trial_times: Floats  # (m, n)
    gradients: Floats  # (m, n)
    captures: Floats  # (n, CAPTURE)
    slopes: Floats  # (3, n)
    curvature: Floats  # (n, n)
    shaped: Floats  # (n, n) curvature made fit for the quadratic programme
    factor: Floats  # (n, n)
    vectors: Floats  # (n, n)
    sizes: Floats  # (n,)
    pull: Floats  # (n,)
    low: Floats  # (n,)
    high: Floats  # (n,)
    step: Floats  # (n,)
    values: Floats  # (m,)
    found: Ints  # (n,) the sequence that the dynamic programme found
    subsets: SubsetScratch
    quadratic: QuadraticScratch


class Tally(NamedTuple):
    """What an ascent cost."""

    steps: int
    programmes: int
    interceptions: int


@compiled
def most_columns(n: int) -> int:
    """How many sequences are carried for a team of n: n + 1 can be active at once."""
    return 2 * n + 4


@allocating
def make_columns(n: int) -> Columns:
    """Columns of a team of up to n, none yet."""
    m = most_columns(n)
    return Columns(np.zeros(1, np.int64), np.empty((m, n), np.int64), np.zeros(m))


@allocating
def ascent_scratch(n: int) -> AscentScratch:
    """Allocate the scratch of `ascend` for teams of up to n."""
    m = most_columns(n)
    return AscentScratch(
        np.empty((n, PATH)),
        np.empty((n, PATH)),
        np.empty(n),
        np.empty(n),
        np.empty((m, n)),
        np.empty((m, n)),
        np.empty((m, n)),
        np.empty((n, CAPTURE)),
        np.empty((3, n)),
        np.empty((n, n)),
        np.empty((n, n)),
        np.empty((n, n)),
        np.empty((n, n)),
        np.empty(n),
        np.empty(n),
        np.empty(n),
        np.empty(n),
        np.empty(n),
        np.empty(m),
        np.empty(n, np.int64),
        subset_scratch(n),
        quadratic_scratch(n, m),
    )


@compiled
def ascend(
    evaders: Table,
    pursuit: Pursuit,
    turns: Floats,
    columns: Columns,
    box: float,
    tolerance: float,
    most_steps: int,
    scratch: AscentScratch,
) -> tuple[float, int, Tally]:
    """Improve `turns` in place to a local maximum; return its exact value, how it ended, the cost.

    The value never falls below that of the turns given. `box` is the largest first change of a
    turn; the ascent has converged when the model promises less than `tolerance`, relative.
    """
    n = len(turns)
    paths, trial_paths = scratch.paths, scratch.trial_paths
    times, trial_times = scratch.times, scratch.trial_times
    set_paths(evaders, turns, pursuit.speed, paths)
    value = _column_times(paths, n, pursuit, columns, times)
    value, _, interceptions = _exact_value(paths, n, pursuit, columns, value, times, scratch)
    programmes, steps, ended = 1, 0, STEPS_USED_UP
    straightened, unit = False, 1.0
    moved = True  # gradients and curvature belong to other turns
    while steps < most_steps:
        if moved:
            unit = _unit_of(value)
            _linearise(paths, n, pursuit, columns, times, unit, scratch)
            straightened = _shape(n, columns, times, True, unit, scratch)
        promise = _best_step(turns, n, columns, times, box, unit, scratch)
        if straightened and promise - value <= tolerance * value:
            straightened = _shape(n, columns, times, False, unit, scratch)
            promise = _best_step(turns, n, columns, times, box, unit, scratch)
        if promise - value <= tolerance * value:
            promise = _way_off_a_saddle(
                evaders, n, pursuit, turns, columns, times, unit, trial_paths, trial_times, scratch
            )
            if promise - value <= 2.0 * tolerance * value:
                ended = CONVERGED
                break
        steps += 1
        trial = _try_step(evaders, n, pursuit, turns, columns, trial_paths, trial_times, scratch)
        for _ in range(_MOST_CORRECTIONS):
            if trial - value < _DISAPPOINTING * (promise - value):
                trial = _correct(
                    evaders,
                    n,
                    pursuit,
                    turns,
                    columns,
                    trial,
                    box,
                    unit,
                    trial_paths,
                    trial_times,
                    scratch,
                )
            if trial <= value:
                break
            trial, joined, cost = _exact_value(
                trial_paths, n, pursuit, columns, trial, trial_times, scratch
            )
            programmes += 1
            interceptions += cost
            if joined < 0:
                break
            _linearise_one(paths, n, pursuit, columns, joined, times, unit, scratch)
            if trial > value:
                break
        gained = (trial - value) / (promise - value)
        longest = 0.0
        for i in range(n):
            longest = max(longest, abs(scratch.turns[i] - turns[i]))
        moved = gained > 0.0
        if moved:
            value = trial
            for i in range(n):
                turns[i] = scratch.turns[i]
            paths, trial_paths = trial_paths, paths
            times, trial_times = trial_times, times
        if gained < 0.25:
            box = (0.5 if gained > -1.0 else 0.25) * longest
        elif gained > 0.7:
            box = min(max(box, 2.0 * longest), math.pi)
        if box < _LEAST_BOX:
            ended = STALLED
            break
    return value, ended, Tally(steps, programmes, interceptions)


@inlined
def _unit_of(value: float) -> float:
    """A power of two that brings times to about one, whatever unit they come in.

    The quadratic programme compares times with radians; a power of two rounds nothing.
    """
    return math.ldexp(1.0, -math.frexp(value)[1]) if value > 0.0 else 1.0


@compiled
def _try_step(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    turns: Floats,
    columns: Columns,
    paths: Table,
    times: Table,
    scratch: AscentScratch,
) -> float:
    """Move `turns` by the step; return the least of the columns there, no less than the value."""
    for i in range(n):
        scratch.turns[i] = min(max(turns[i] + scratch.step[i], -math.pi), math.pi)
    set_paths(evaders, scratch.turns[:n], pursuit.speed, paths)
    return _column_times(paths, n, pursuit, columns, times)


@compiled
def _correct(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    turns: Floats,
    columns: Columns,
    trial: float,
    box: float,
    unit: float,
    paths: Table,
    times: Table,
    scratch: AscentScratch,
) -> float:
    """Replace a trial that disappoints by its second-order correction, if that is better."""
    for i in range(n):
        scratch.first_turns[i] = scratch.turns[i]
    _corrected_step(turns, n, columns, times, box, unit, scratch)
    second = _try_step(evaders, n, pursuit, turns, columns, paths, times, scratch)
    if second > trial:
        return second
    for i in range(n):
        scratch.turns[i] = scratch.first_turns[i]
    set_paths(evaders, scratch.turns[:n], pursuit.speed, paths)
    return _column_times(paths, n, pursuit, columns, times)


@compiled
def _column_times(paths: Table, n: int, pursuit: Pursuit, columns: Columns, times: Table) -> float:
    """Write the capture times of all columns; return the least of their last ones."""
    value = math.inf
    for s in range(columns.used[0]):
        value = min(value, capture_times(paths, pursuit, columns.sequences[s, :n], times[s]))
    return value


@compiled
def _exact_value(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    columns: Columns,
    bound: float,
    times: Table,
    scratch: AscentScratch,
) -> tuple[float, int, int]:
    """The exact minimum over all sequences, where `bound` is the least of the columns.

    Returns also the column that joined because it is below the bound, or -1, and the cost.
    """
    least, interceptions = least_time(
        paths,
        n,
        pursuit,
        bound,
        scratch.found,
        scratch.subsets,
    )
    joined = -1
    if least < bound:
        joined = _join(columns, n, scratch.found, times)
        capture_times(paths, pursuit, columns.sequences[joined, :n], times[joined])
    return least, joined, interceptions


@compiled
def _join(columns: Columns, n: int, sequence: Ints, times: Floats) -> int:
    """Add a column; where all rows are taken, in place of the idle one that is captured last."""
    slot = columns.used[0]
    if slot < len(columns.weights):
        columns.used[0] += 1
    else:
        slot, idlest = 0, -math.inf
        for s in range(len(columns.weights)):
            if columns.weights[s] == 0.0 and times[s, n - 1] > idlest:
                slot, idlest = s, times[s, n - 1]
    for k in range(n):
        columns.sequences[slot, k] = sequence[k]
    columns.weights[slot] = 0.0
    return slot


@compiled
def _linearise(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    columns: Columns,
    times: Floats,
    unit: float,
    scratch: AscentScratch,
) -> None:
    """Gradients of all columns, and the curvature of their Lagrangian, sign turned."""
    count, weights = columns.used[0], columns.weights
    worst, total = 0, 0.0
    for s in range(count):
        total += weights[s]
        if times[s, n - 1] < times[worst, n - 1]:
            worst = s
    if total == 0.0:
        weights[worst] = 1.0
    curvature = scratch.curvature
    for i in range(n):
        for j in range(n):
            curvature[i, j] = 0.0
    for s in range(count):
        sequence = columns.sequences[s, :n]
        differentiate(paths, pursuit, sequence, times[s], scratch.captures, scratch.gradients[s])
        for i in range(n):
            scratch.gradients[s, i] *= unit
        if weights[s] > 0.0:
            add_curvature(
                paths,
                pursuit,
                sequence,
                times[s],
                scratch.captures,
                -weights[s] * unit,
                scratch.slopes,
                curvature,
            )


@compiled
def _linearise_one(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    columns: Columns,
    s: int,
    times: Table,
    unit: float,
    scratch: AscentScratch,
) -> None:
    """Capture times and gradient, at the present turns, of a column that joined at other ones."""
    sequence = columns.sequences[s, :n]
    capture_times(paths, pursuit, sequence, times[s])
    differentiate(paths, pursuit, sequence, times[s], scratch.captures, scratch.gradients[s])
    for i in range(n):
        scratch.gradients[s, i] *= unit


@compiled
def _shape(
    n: int, columns: Columns, times: Table, straighten: bool, unit: float, scratch: AscentScratch
) -> bool:
    """Factor the curvature for the quadratic programme; return whether it was straightened.

    The columns that are active decide the step along the differences of their gradients, whatever
    the curvature there. Where the curvature has a wrong sign, a penalty on missing the point where
    those columns agree makes it right without moving that point (an augmented Lagrangian), and
    Newton's method stays quadratic. Without it the sign is mended by force, which is slow but safe.
    """
    for i in range(n):
        scratch.pull[i] = 0.0
    if factorise(scratch.curvature, n, scratch.factor):
        return False
    _copy_curvature(n, scratch)
    straightened = straighten and _penalise(n, columns, times, unit, scratch)
    if not factorise(scratch.shaped, n, scratch.factor):
        make_positive(scratch.shaped, n, scratch.vectors, scratch.sizes)
        factorise(scratch.shaped, n, scratch.factor)
    return straightened


@compiled
def _way_off_a_saddle(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    turns: Floats,
    columns: Columns,
    times: Table,
    unit: float,
    trial_paths: Table,
    trial_times: Table,
    scratch: AscentScratch,
) -> float:
    """Write the step along the direction that bends upwards most; return what the columns reach.

    Where no gradient is left the ascent may stand on a saddle. -inf if nothing bends upwards, seen
    along the active columns.
    """
    if factorise(scratch.curvature, n, scratch.factor):
        return -math.inf
    _copy_curvature(n, scratch)
    _penalise(n, columns, times, unit, scratch)
    if factorise(scratch.shaped, n, scratch.factor):
        return -math.inf
    diagonalise(scratch.shaped, n, scratch.vectors)
    upwards = 0
    for k in range(n):
        if scratch.shaped[k, k] < scratch.shaped[upwards, upwards]:
            upwards = k
    reached = -math.inf
    for side in (-_STRIDE, _STRIDE):
        for i in range(n):
            scratch.step[i] = side * scratch.vectors[i, upwards]
        here = _try_step(evaders, n, pursuit, turns, columns, trial_paths, trial_times, scratch)
        if side > 0.0 and here < reached:
            for i in range(n):
                scratch.step[i] = -scratch.step[i]
        reached = max(reached, here)
    return reached


@inlined
def _copy_curvature(n: int, scratch: AscentScratch) -> None:
    for i in range(n):
        for j in range(i + 1):
            scratch.shaped[i, j] = scratch.curvature[i, j]


@compiled
def _penalise(n: int, columns: Columns, times: Table, unit: float, scratch: AscentScratch) -> bool:
    """Add to `shaped` and `pull` the penalty on active columns that differ; False if none do."""
    shaped, pull, mean, gradients = scratch.shaped, scratch.pull, scratch.step, scratch.gradients
    weights, count = columns.weights, columns.used[0]
    value = size = 0.0
    for i in range(n):
        mean[i] = 0.0
        for j in range(i + 1):
            size = max(size, abs(shaped[i, j]))
    for s in range(count):
        value += weights[s] * times[s, n - 1]
        for i in range(n):
            mean[i] += weights[s] * gradients[s, i]
    shortest = math.inf
    for s in range(count):
        if weights[s] > 0.0:
            length = 0.0
            for i in range(n):
                length += (gradients[s, i] - mean[i]) ** 2
            if length > 0.0:
                shortest = min(shortest, length)
    if shortest == math.inf:
        return False
    penalty = _PENALTY * size / shortest
    for s in range(count):
        if weights[s] > 0.0:
            for i in range(n):
                off = penalty * (gradients[s, i] - mean[i])
                pull[i] -= off * unit * (times[s, n - 1] - value)
                for j in range(i + 1):
                    shaped[i, j] += off * (gradients[s, j] - mean[j])
    return True


@compiled
def _best_step(
    turns: Floats,
    n: int,
    columns: Columns,
    times: Floats,
    box: float,
    unit: float,
    scratch: AscentScratch,
) -> float:
    """Write the step that the model thinks best inside the box; return the value it promises."""
    for s in range(columns.used[0]):
        scratch.values[s] = unit * times[s, n - 1]
    return _solve(turns, n, columns, box, scratch) / unit


@compiled
def _corrected_step(
    turns: Floats,
    n: int,
    columns: Columns,
    tried: Table,
    box: float,
    unit: float,
    scratch: AscentScratch,
) -> None:
    """Write a second-order correction of the step: what the model missed, added to its values.

    Each column's own curvature differs from the Lagrangian's, so where several are active the least
    of them falls short of the promise, however small the step (the Maratos effect).
    """
    for s in range(columns.used[0]):
        scratch.values[s] = unit * tried[s, n - 1]
        for i in range(n):
            scratch.values[s] -= scratch.gradients[s, i] * (scratch.turns[i] - turns[i])
    _solve(turns, n, columns, box, scratch)


@compiled
def _solve(turns: Floats, n: int, columns: Columns, box: float, scratch: AscentScratch) -> float:
    """Solve the quadratic programme for `scratch.values`, turns kept in the box and in [-π, π]."""
    for i in range(n):
        scratch.low[i] = max(-math.pi - turns[i], -box)
        scratch.high[i] = min(math.pi - turns[i], box)
    return solve_quadratic(
        n,
        columns.used[0],
        scratch.values,
        scratch.gradients,
        scratch.factor,
        scratch.pull,
        scratch.low,
        scratch.high,
        scratch.step,
        columns.weights,
        scratch.quadratic,
    )
