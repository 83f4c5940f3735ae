"""The curvature of the local model: mended where it has a wrong sign, and followed off a saddle."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats
from covey.kernels.linalg.symmetric import diagonalise, factorise, make_positive
from covey.kernels.maximum.local_model import ModelScratch
from covey.kernels.maximum.working_set import Columns

_PENALTY = 20.0  # of the curvature, across the active columns
_FARTHEST = 1e5  # radians to the maximum of a single column, at most
_DRIFT, _NEGLIGIBLE = 0.1, 1e-6  # of the weights, which sum to one
_STRIDE = 0.03  # how far from a saddle the ways off it are tried, radians


@compiled
def shape(
    n: int, columns: Columns, values: Floats, straighten: bool, unit: float, scratch: ModelScratch
) -> tuple[bool, bool]:
    """Factor the curvature for the quadratic programme; return how it was changed for that.

    The first is whether it was straightened, the second whether its sign was mended by force.
    Neither leaves it so flat that a column alone would lead too far: what the quadratic programme
    rounds grows with that, until a step that gains much promises nothing.

    The columns that are active decide the step along the differences of their gradients, whatever
    the curvature there. Where the curvature has a wrong sign, a penalty on missing the point where
    those columns agree makes it right without moving that point (an augmented Lagrangian), and
    Newton's method stays quadratic. Without it the sign is mended by force, which is slow but safe.
    """
    steepest = 0.0
    for i in range(n):
        scratch.pull[i] = 0.0
        for s in range(columns.used[0]):
            steepest = max(steepest, abs(scratch.gradients[s, i]))
    floor = steepest / _FARTHEST
    if factorise(scratch.curvature, n, floor, scratch.factor):
        return False, False
    _copy_curvature(n, scratch)
    straightened = straighten and _penalise(n, columns, values, unit, scratch)
    if factorise(scratch.shaped, n, floor, scratch.factor):
        return straightened, False
    make_positive(scratch.shaped, n, floor, scratch.vectors, scratch.sizes)
    factorise(scratch.shaped, n, 0.0, scratch.factor)
    return straightened, True


@compiled
def drifted(columns: Columns, scratch: ModelScratch) -> bool:
    """Whether the last step weighs the columns otherwise than their curvature was weighed."""
    drift = 0.0
    for s in range(columns.used[0]):
        drift += abs(columns.weights[s] - scratch.weights[s])
    return drift > _DRIFT


@compiled
def ways_off(n: int, columns: Columns, values: Floats, unit: float, scratch: ModelScratch) -> int:
    """Return how many steps there are to try where no gradient is left, see `take_way`.

    None where everything bends downwards, seen along the active columns: no saddle, no plateau.
    """
    if factorise(scratch.curvature, n, 0.0, scratch.factor):
        return 0
    _copy_curvature(n, scratch)
    _penalise(n, columns, values, unit, scratch)
    if factorise(scratch.shaped, n, 0.0, scratch.factor):
        return 0
    diagonalise(scratch.shaped, n, scratch.vectors)
    upwards = 0
    for k in range(n):
        if scratch.shaped[k, k] < scratch.shaped[upwards, upwards]:
            upwards = k
    for i in range(n):
        scratch.sizes[i] = scratch.vectors[i, upwards]
    return 2 * n + 2


@inlined
def take_way(way: int, n: int, scratch: ModelScratch) -> None:
    """Write the step: to either side one turn alone or, last, what bends upwards most.

    On a plateau, where an evader is caught while it turns, no curvature says which turn to change.
    """
    side = _STRIDE if way % 2 == 0 else -_STRIDE
    for i in range(n):
        alone = 1.0 if i == way // 2 else 0.0
        scratch.step[i] = side * (alone if way < 2 * n else scratch.sizes[i])


@inlined
def _copy_curvature(n: int, scratch: ModelScratch) -> None:
    for i in range(n):
        for j in range(i + 1):
            scratch.shaped[i, j] = scratch.curvature[i, j]


@compiled
def _penalise(n: int, columns: Columns, values: Floats, unit: float, scratch: ModelScratch) -> bool:
    """Add to `shaped` and `pull` the penalty on active columns that differ; False if none do.

    They are compared with the heaviest one. From their mean, which is next to it where the others
    weigh little, it differs by next to nothing, and the penalty would stop the ascent.
    """
    shaped, pull, apart, gradients = scratch.shaped, scratch.pull, scratch.step, scratch.gradients
    weights, count = columns.weights, columns.used[0]
    heaviest, size, shortest = 0, 0.0, math.inf
    for i in range(n):
        for j in range(i + 1):
            size = max(size, abs(shaped[i, j]))
    for s in range(count):
        if weights[s] > weights[heaviest]:
            heaviest = s
    for s in range(count):
        if weights[s] > _NEGLIGIBLE:
            length = 0.0
            for i in range(n):
                length += (gradients[s, i] - gradients[heaviest, i]) ** 2
            if length > 0.0:
                shortest = min(shortest, length)
    if shortest == math.inf:
        return False
    penalty = _PENALTY * size / shortest
    for s in range(count):
        if weights[s] > _NEGLIGIBLE and s != heaviest:
            short = unit * (values[s] - values[heaviest])
            for i in range(n):
                apart[i] = gradients[s, i] - gradients[heaviest, i]
                pull[i] -= penalty * apart[i] * short
                for j in range(i + 1):
                    shaped[i, j] += penalty * apart[i] * apart[j]
    return True
