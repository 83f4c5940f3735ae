"""The local model of the objective around some turns, and the step that maximises the model.

Each sequence of the working set is linearised. All share the exact Hessian of the Lagrangian, which
`curvature` factors. The step maximises the minimum of the linear models, less the quadratic term,
inside a trust region of the maximum norm.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Matrix, Vector, Workspace, floats, path_rows, rows
from covey.kernels.capture.derivatives import Captures, add_curvature, differentiate
from covey.kernels.linalg.active_set import QuadraticScratch, quadratic_scratch
from covey.kernels.linalg.quadratic_program import (
    QuadraticProgram,
    Solution,
    solve_quadratic,
)
from covey.kernels.maximum.problem import Iterate, Problem
from covey.kernels.maximum.working_set import Evaluation, WorkingSet, capacity


class ModelScratch(NamedTuple):
    """Arrays of the model of n turns with up to m sequences."""

    gradients: Matrix  # (m, n)
    weights: Vector  # (m,) multipliers in the Hessian
    capture_rows: Matrix  # (n, CAPTURE_ROW) or more columns
    slopes: Matrix  # (3, n)
    hessian: Matrix  # (n, n) of the Lagrangian, sign turned; lower triangle
    convex_hessian: Matrix  # (n, n) made positive definite for the quadratic programme
    factor: Matrix  # (n, n)
    eigenvectors: Matrix  # (n, n)
    eigenvalues: Vector  # (n,)
    linear: Vector  # (n,) linear term of the penalty
    lower: Vector  # (n,) bounds of the step
    upper: Vector  # (n,)
    step: Vector  # (n,) the maximiser
    values: Vector  # (m,)
    quadratic: QuadraticScratch


@inlined
def model_scratch(workspace: Workspace) -> ModelScratch:
    """Carve the scratch of a model."""
    n = workspace.size
    m = capacity(n)
    return ModelScratch(
        rows(workspace, m),
        floats(workspace, m),
        path_rows(workspace, n),
        rows(workspace, 3),
        rows(workspace, n),
        rows(workspace, n),
        rows(workspace, n),
        rows(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, m),
        quadratic_scratch(workspace, n, m),
    )


@inlined
def power_of_two_scale(value: float) -> float:
    """Return a power of two that brings times to about one, whatever their unit.

    The quadratic programme compares times with radians. A power of two rounds nothing.
    """
    return math.ldexp(1.0, -math.frexp(value)[1]) if value > 0.0 else 1.0


@compiled
def build_model(
    problem: Problem,
    working_set: WorkingSet,
    here: Evaluation,
    scale: float,
    scratch: ModelScratch,
) -> None:
    """Write the gradients of all sequences, and the Hessian of their Lagrangian, sign turned.

    Where no sequence has a multiplier yet, the worst sequence gets all the weight.
    """
    n, count, weights = len(problem.evaders), working_set.used[0], working_set.weights
    worst, total_weight = 0, 0.0
    for s in range(count):
        total_weight += weights[s]
        if here.values[s] < here.values[worst]:
            worst = s
    if total_weight == 0.0:
        weights[worst] = 1.0
    clear_hessian(n, scratch)
    for s in range(count):
        linearise(problem, working_set, here, s, scale, scratch)
        if weights[s] > 0.0:
            add_curvature(
                here.paths,
                problem.pursuit,
                working_set.sequences[s, :n],
                captures_of(here, s, scratch),
                -weights[s] * scale,
                scratch.hessian,
            )


@inlined
def clear_hessian(n: int, scratch: ModelScratch) -> None:
    """Set the Hessian to zero."""
    for i in range(n):
        for j in range(n):
            scratch.hessian[i, j] = 0.0


@inlined
def linearise(
    problem: Problem,
    working_set: WorkingSet,
    here: Evaluation,
    s: int,
    scale: float,
    scratch: ModelScratch,
) -> None:
    """Write the gradient of sequence s, and the multiplier with which the Hessian weights it.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective.
    working_set
        Sequences and multipliers.
    here
        Paths and capture times at the iterate.
    s
        Row of the working set.
    scale
        Power of two that the times are multiplied by.
    scratch
        `gradients[s]` and `weights[s]` are modified in place.
    """
    n = len(problem.evaders)
    scratch.weights[s] = working_set.weights[s]
    differentiate(
        here.paths,
        problem.pursuit,
        working_set.sequences[s, :n],
        problem.objective.total,
        captures_of(here, s, scratch),
        scratch.gradients[s],
    )
    for i in range(n):
        scratch.gradients[s, i] *= scale


@inlined
def captures_of(here: Evaluation, s: int, scratch: ModelScratch) -> Captures:
    """Return the record of the captures of sequence s, which its derivatives share."""
    return Captures(here.times[s], scratch.capture_rows, scratch.slopes)


@compiled
def best_step(
    iterate: Iterate, values: Floats, radius: float, scale: float, scratch: ModelScratch
) -> float:
    """Write the step that maximises the model inside the trust region; return its value."""
    for s in range(iterate.working_set.used[0]):
        scratch.values[s] = scale * values[s]
    return _solve(iterate, radius, scratch) / scale


@compiled
def corrected_step(
    iterate: Iterate,
    trial: Floats,
    trial_values: Floats,
    radius: float,
    scale: float,
    scratch: ModelScratch,
) -> None:
    """Write a second-order correction of the step to the turns `trial`.

    The error of each linear model at the trial is added to its value, and the programme is solved
    again. Each sequence's own curvature differs from the Lagrangian's. So where several sequences
    are active, their minimum falls short of the prediction, however small the step (the Maratos
    effect).

    Parameters
    ----------
    iterate
        (n,) turns, and the working set, whose multipliers are modified in place.
    trial
        (n,) turns after the first step.
    trial_values
        (m,) objective of each sequence there.
    radius
        Of the trust region, radians.
    scale
        Power of two that the times are multiplied by.
    scratch
        Holds the model; `step` is modified in place.
    """
    turns = iterate.turns
    for s in range(iterate.working_set.used[0]):
        scratch.values[s] = scale * trial_values[s]
        for i in range(len(turns)):
            scratch.values[s] -= scratch.gradients[s, i] * (trial[i] - turns[i])
    _solve(iterate, radius, scratch)


@compiled
def _solve(iterate: Iterate, radius: float, scratch: ModelScratch) -> float:
    """Solve the quadratic programme for `scratch.values`; turns stay in [-π, π]."""
    turns, working_set = iterate.turns, iterate.working_set
    n, m = len(turns), working_set.used[0]
    for i in range(n):
        scratch.lower[i] = max(-math.pi - turns[i], -radius)
        scratch.upper[i] = min(math.pi - turns[i], radius)
    program = QuadraticProgram(
        scratch.values[:m],
        scratch.gradients,
        scratch.factor,
        scratch.linear[:n],
        scratch.lower[:n],
        scratch.upper[:n],
    )
    solution = Solution(scratch.step[:n], working_set.weights[:m])
    return solve_quadratic(program, solution, scratch.quadratic)
