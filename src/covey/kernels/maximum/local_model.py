"""The local model of the guaranteed time around some turns, and the step that is best for it.

Each column is linear; all share the exact curvature of their Lagrangian, mended (in `curvature`)
where it has a wrong sign. The step maximises the least of them inside a box.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Pursuit
from covey.kernels.capture.sequence import CAPTURE, add_curvature, differentiate
from covey.kernels.linalg.quadratic_program import (
    QuadraticScratch,
    quadratic_scratch,
    solve_quadratic,
)
from covey.kernels.maximum.working_set import Columns, Point, most_columns


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
