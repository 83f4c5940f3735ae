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

from covey.kernels._jit import allocating, compiled
from covey.kernels.path import PATH, set_paths
from covey.kernels.quadratic import (
    QuadraticScratch,
    factorise,
    quadratic_scratch,
    solve_quadratic,
)
from covey.kernels.sequence import CAPTURE, add_curvature, capture_times, differentiate
from covey.kernels.subsets import least_time
from covey.kernels.types import Floats, Ints, Pursuit, Table

CONVERGED, STALLED, STEPS_USED_UP = range(3)

_LEAST_BOX = 1e-9
_PENALTY = 100.0


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
    times: Floats  # (m, n) capture times of each column
    trial_times: Floats  # (m, n)
    gradients: Floats  # (m, n)
    captures: Floats  # (n, CAPTURE)
    slopes: Floats  # (3, n)
    curvature: Floats  # (n, n)
    factor: Floats  # (n, n)
    pull: Floats  # (n,)
    low: Floats  # (n,)
    high: Floats  # (n,)
    step: Floats  # (n,)
    values: Floats  # (m,)
    found: Ints  # (n,) the sequence that the dynamic programme found
    labels: Floats  # (2**n * n,)
    arrivals: Floats  # (n,)
    members: Ints  # (n,)
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
        np.empty((m, n)),
        np.empty((m, n)),
        np.empty((m, n)),
        np.empty((n, CAPTURE)),
        np.empty((3, n)),
        np.empty((n, n)),
        np.empty((n, n)),
        np.empty(n),
        np.empty(n),
        np.empty(n),
        np.empty(n),
        np.empty(m),
        np.empty(n, np.int64),
        np.empty(n << n),
        np.empty(n),
        np.empty(n, np.int64),
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
    value, joined, interceptions = _exact_value(paths, n, pursuit, columns, times, scratch)
    if joined >= 0:
        capture_times(paths, pursuit, columns.sequences[joined, :n], times[joined])
    programmes, steps, ended = 1, 0, STEPS_USED_UP
    straightened = current = (
        False  # current: whether gradients and curvature belong to the present turns
    )
    while steps < most_steps:
        if not current:
            _linearise(paths, n, pursuit, columns, times, scratch)
            straightened = _shape(n, columns, times, True, scratch)
            current = True
        promise = _best_step(turns, n, columns, times, box, scratch)
        if straightened and promise - value <= tolerance * value:
            straightened = _shape(n, columns, times, False, scratch)
            promise = _best_step(turns, n, columns, times, box, scratch)
        if promise - value <= tolerance * value:
            ended = CONVERGED
            break
        steps += 1
        longest = 0.0
        for i in range(n):
            scratch.turns[i] = min(max(turns[i] + scratch.step[i], -math.pi), math.pi)
            longest = max(longest, abs(scratch.step[i]))
        set_paths(evaders, scratch.turns, pursuit.speed, trial_paths)
        trial, joined, cost = _exact_value(trial_paths, n, pursuit, columns, trial_times, scratch)
        programmes += 1
        interceptions += cost
        gained = (trial - value) / (promise - value)
        if gained > 0.0:
            value = trial
            for i in range(n):
                turns[i] = scratch.turns[i]
            paths, trial_paths = trial_paths, paths
            times, trial_times = trial_times, times
            current = False
        if joined >= 0:
            sequence = columns.sequences[joined, :n]
            capture_times(paths, pursuit, sequence, times[joined])
            differentiate(
                paths, pursuit, sequence, times[joined], scratch.captures, scratch.gradients[joined]
            )
        if gained < 0.25:
            box = (0.5 if gained > -1.0 else 0.25) * longest
        elif gained > 0.7:
            box = min(max(box, 2.0 * longest), math.pi)
        if box < _LEAST_BOX:
            ended = STALLED
            break
    return value, ended, Tally(steps, programmes, interceptions)


@compiled
def _exact_value(
    paths: Table, n: int, pursuit: Pursuit, columns: Columns, times: Floats, scratch: AscentScratch
) -> tuple[float, int, int]:
    """The exact minimum over all sequences, the column that joined for it (or -1), the cost.

    Writes the capture times of the columns that were there.
    """
    value = math.inf
    for s in range(columns.used[0]):
        value = min(value, capture_times(paths, pursuit, columns.sequences[s, :n], times[s]))
    least, interceptions = least_time(
        paths,
        n,
        pursuit,
        value,
        scratch.labels,
        scratch.arrivals,
        scratch.members,
        scratch.found,
    )
    joined = -1
    if least < value:
        joined = _join(columns, n, scratch.found, times)
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
    paths: Table, n: int, pursuit: Pursuit, columns: Columns, times: Floats, scratch: AscentScratch
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
        if weights[s] > 0.0:
            add_curvature(
                paths,
                pursuit,
                sequence,
                times[s],
                scratch.captures,
                -weights[s],
                scratch.slopes,
                curvature,
            )


@compiled
def _shape(
    n: int, columns: Columns, times: Table, straighten: bool, scratch: AscentScratch
) -> bool:
    """Factor the curvature for the quadratic programme; return whether it was straightened.

    The columns that are active decide the step along the differences of their gradients, whatever
    the curvature there. Where the curvature has a wrong sign, a penalty on missing the point where
    those columns agree makes it right without moving that point (an augmented Lagrangian), and
    Newton's method stays quadratic. Without it the sign is mended by force, which is slow but safe.
    """
    curvature, factor, pull = scratch.curvature, scratch.factor, scratch.pull
    for i in range(n):
        pull[i] = 0.0
        for j in range(i + 1):
            factor[i, j] = curvature[i, j]
    if not factorise(factor, n) or not straighten:
        return False
    for i in range(n):
        for j in range(i + 1):
            factor[i, j] = curvature[i, j]
    straightened = _penalise(n, columns, times, scratch)
    factorise(factor, n)
    return straightened


@compiled
def _penalise(n: int, columns: Columns, times: Table, scratch: AscentScratch) -> bool:
    """Add to `factor` and `pull` the penalty on active columns that differ; False if none do."""
    factor, pull, mean, gradients = scratch.factor, scratch.pull, scratch.step, scratch.gradients
    weights, count = columns.weights, columns.used[0]
    value = size = 0.0
    for i in range(n):
        mean[i] = 0.0
        for j in range(i + 1):
            size = max(size, abs(factor[i, j]))
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
                pull[i] -= off * (times[s, n - 1] - value)
                for j in range(i + 1):
                    factor[i, j] += off * (gradients[s, j] - mean[j])
    return True


@compiled
def _best_step(
    turns: Floats, n: int, columns: Columns, times: Floats, box: float, scratch: AscentScratch
) -> float:
    """Write the step that the model thinks best inside the box; return the value it promises."""
    for i in range(n):
        scratch.low[i] = max(-math.pi - turns[i], -box)
        scratch.high[i] = min(math.pi - turns[i], box)
    count = columns.used[0]
    for s in range(count):
        scratch.values[s] = times[s, n - 1]
    return solve_quadratic(
        n,
        count,
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
