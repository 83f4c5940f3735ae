"""The local model of the guaranteed time around some turns, and the step that is best for it.

Each column is linear; all share the exact curvature of their Lagrangian, mended where it has a
wrong sign. The step maximises the least of them inside a box.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.columns import Columns, Point, most_columns
from covey.kernels.definite import diagonalise, factorise, make_positive
from covey.kernels.quadratic import QuadraticScratch, quadratic_scratch, solve_quadratic
from covey.kernels.sequence import CAPTURE, add_curvature, differentiate
from covey.kernels.types import Floats, Pursuit

_PENALTY = 20.0  # of the curvature, across the active columns
_FARTHEST = 1e5  # radians to the maximum of a single column, at most
_DRIFT, _NEGLIGIBLE = 0.1, 1e-6  # of the weights, which sum to one
_STRIDE = 0.03  # how far from a saddle the ways off it are tried, radians


class ModelScratch(NamedTuple):
    """Arrays of the model of n turns with up to m columns."""

    gradients: Floats  # (m, n)
    weights: Floats  # (m,) of the columns in the curvature
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
    step: Floats  # (n,) the best one
    values: Floats  # (m,)
    quadratic: QuadraticScratch


@allocating
def model_scratch(n: int) -> ModelScratch:
    """Allocate the scratch of a model of up to n turns."""
    m = most_columns(n)
    return ModelScratch(
        np.empty((m, n)),
        np.empty(m),
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
        quadratic_scratch(n, m),
    )


@inlined
def unit_of(value: float) -> float:
    """A power of two that brings times to about one, whatever unit they come in.

    The quadratic programme compares times with radians; a power of two rounds nothing.
    """
    return math.ldexp(1.0, -math.frexp(value)[1]) if value > 0.0 else 1.0


@compiled
def linearise(
    point: Point,
    n: int,
    pursuit: Pursuit,
    total: bool,
    columns: Columns,
    unit: float,
    scratch: ModelScratch,
) -> None:
    """Gradients of all columns, and the curvature of their Lagrangian, sign turned."""
    count, weights = columns.used[0], columns.weights
    worst, held = 0, 0.0
    for s in range(count):
        held += weights[s]
        if point.values[s] < point.values[worst]:
            worst = s
    if held == 0.0:
        weights[worst] = 1.0
    curvature = scratch.curvature
    for i in range(n):
        for j in range(n):
            curvature[i, j] = 0.0
    for s in range(count):
        linearise_one(point, n, pursuit, total, columns, s, unit, scratch)
        if weights[s] > 0.0:
            add_curvature(
                point.paths,
                pursuit,
                columns.sequences[s, :n],
                point.times[s],
                scratch.captures,
                -weights[s] * unit,
                scratch.slopes,
                curvature,
            )


@inlined
def linearise_one(
    point: Point,
    n: int,
    pursuit: Pursuit,
    total: bool,
    columns: Columns,
    s: int,
    unit: float,
    scratch: ModelScratch,
) -> None:
    """Gradient of one column, and the weight that it has for now."""
    scratch.weights[s] = columns.weights[s]
    differentiate(
        point.paths,
        pursuit,
        columns.sequences[s, :n],
        total,
        point.times[s],
        scratch.captures,
        scratch.gradients[s],
    )
    for i in range(n):
        scratch.gradients[s, i] *= unit


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


@compiled
def best_step(
    turns: Floats,
    n: int,
    columns: Columns,
    values: Floats,
    box: float,
    unit: float,
    scratch: ModelScratch,
) -> float:
    """Write the step that the model thinks best inside the box; return the value it promises."""
    for s in range(columns.used[0]):
        scratch.values[s] = unit * values[s]
    return _solve(turns, n, columns, box, scratch) / unit


@compiled
def corrected_step(
    turns: Floats,
    trial: Floats,
    n: int,
    columns: Columns,
    tried: Floats,
    box: float,
    unit: float,
    scratch: ModelScratch,
) -> None:
    """Write a second-order correction of the step: what the model missed, added to its values.

    Each column's own curvature differs from the Lagrangian's, so where several are active the least
    of them falls short of the promise, however small the step (the Maratos effect).
    """
    for s in range(columns.used[0]):
        scratch.values[s] = unit * tried[s]
        for i in range(n):
            scratch.values[s] -= scratch.gradients[s, i] * (trial[i] - turns[i])
    _solve(turns, n, columns, box, scratch)


@compiled
def _solve(turns: Floats, n: int, columns: Columns, box: float, scratch: ModelScratch) -> float:
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
