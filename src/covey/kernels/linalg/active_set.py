"""The active set of a quadratic programme: how a constraint is added, and others are dropped.

Goldfarb and Idnani (1983). Constraints are whitened: a_j becomes L^-1 a_j, with L the Cholesky
factor of the programme's matrix, so that products of constraints are plain dot products.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import (
    Floats,
    Ints,
    IntVector,
    Matrix,
    Vector,
    Workspace,
    floats,
    ints,
    rows,
    wide_rows,
)

TINY = 1e-14


class QuadraticScratch(NamedTuple):
    """Arrays of the active-set method for n variables and up to m models."""

    whitened: Matrix  # (m + 2n, n) L^-1 a_j for each constraint j
    active: IntVector  # (n + 2,)
    multipliers: Vector  # (n + 2,) of the active constraints
    gram: Matrix  # (n + 2, n + 2) their products, then its Cholesky factor
    ones: Vector  # (n + 2,)
    direction: Vector  # (n + 2,)
    combined: Vector  # (n,) sum of multipliers times whitened


@inlined
def quadratic_scratch(workspace: Workspace, n: int, m: int) -> QuadraticScratch:
    """Carve the scratch of `solve_quadratic` for n = `workspace.size` variables and m models."""
    return QuadraticScratch(
        rows(workspace, m + 2 * n),
        ints(workspace, n + 2),
        floats(workspace, n + 2),
        wide_rows(workspace, n + 2),
        floats(workspace, n + 2),
        floats(workspace, n + 2),
        floats(workspace, n),
    )


class ActiveSet(NamedTuple):
    """How many constraints are active, and z."""

    size: int
    z: float


@compiled
def activate(
    n: int,
    m: int,
    added: int,
    violation: float,
    active_set: ActiveSet,
    scratch: QuadraticScratch,
) -> ActiveSet:
    """Raise the multiplier of constraint `added` until it holds; drop those that come to zero.

    1. The direction in which the active multipliers move keeps the active constraints active.
    2. The full step makes the added constraint hold. A partial step ends where an active multiplier
       comes to zero.
    3. After a partial step its constraint is dropped, and a new direction follows.

    Parameters
    ----------
    n, m
        Numbers of variables and of models.
    added
        The constraint, whose whitened row is in `scratch`.
    violation
        Its slack, < 0.
    active_set
        Before.
    scratch
        Active constraints, multipliers and combined row are modified in place.

    Returns
    -------
    ActiveSet
        After. The constraint is left out where it depends on the active ones: nothing is gained.
    """
    whitened, active, multipliers = scratch.whitened, scratch.active, scratch.multipliers
    count, z = active_set.size, active_set.z
    raised = 0.0
    while count < n + 2:
        if added < m and not _holds_model(m, active, count):
            z += violation  # no model holds z any more: lower z to the model that is added
            break
        slope, curvature, own = _direction_and_curvature(n, m, added, count, scratch)
        full = -violation / curvature if curvature > TINY * own else math.inf
        partial, dropped = _first_to_vanish(count, scratch)
        length = min(full, partial)
        if length == math.inf:
            return ActiveSet(count, z)
        raised += length
        z += length * slope
        violation += length * curvature
        for i in range(n):
            scratch.combined[i] += length * whitened[added, i]
        for k in range(count):
            multipliers[k] += length * scratch.direction[k]
            for i in range(n):
                scratch.combined[i] += length * scratch.direction[k] * whitened[active[k], i]
        if full <= partial:
            break
        count -= 1
        active[dropped], multipliers[dropped] = active[count], multipliers[count]
    active[count], multipliers[count] = added, raised
    return ActiveSet(count + 1, z)


@compiled
def _holds_model(m: int, active: Ints, count: int) -> bool:
    """Whether a model is among the active constraints."""
    models = 0
    for k in range(count):
        models += active[k] < m
    return models > 0


@compiled
def _direction_and_curvature(
    n: int, m: int, added: int, count: int, scratch: QuadraticScratch
) -> tuple[float, float, float]:
    """Write the direction; return the slopes of z and of the violation, and the row's square."""
    whitened, is_model = scratch.whitened, 1.0 if added < m else 0.0
    slope = _direction(n, m, added, is_model, count, scratch)
    curvature = -is_model * slope
    for k in range(count):
        curvature += scratch.direction[k] * dot(whitened[added], whitened[scratch.active[k]], n)
    own = dot(whitened[added], whitened[added], n)
    return slope, curvature + own, own


@compiled
def _first_to_vanish(count: int, scratch: QuadraticScratch) -> tuple[float, int]:
    """Return the step at which the first active multiplier comes to zero, and whose it is."""
    partial, dropped = math.inf, -1
    for k in range(count):
        if scratch.direction[k] < 0.0:
            step = -scratch.multipliers[k] / scratch.direction[k]
            if step < partial:
                partial, dropped = step, k
    return partial, dropped


@compiled
def _direction(
    n: int, m: int, added: int, is_model: float, count: int, scratch: QuadraticScratch
) -> float:
    """Write how the active multipliers move as that of `added` grows; return how z moves.

    Solves  M v - e s = -M_added,  e'v = -(1 if a model is added)  for v and s, with M the products
    of the active constraints and e marking the models, through the Cholesky factor of M + κ e e'.
    """
    whitened, active, gram = scratch.whitened, scratch.active, scratch.gram
    ones, direction = scratch.ones, scratch.direction
    kappa = 0.0
    for k in range(count):
        for j in range(k + 1):
            gram[k, j] = dot(whitened[active[k]], whitened[active[j]], n)
        if active[k] < m:
            kappa = max(kappa, gram[k, k])
    if kappa == 0.0:
        kappa = 1.0
    for k in range(count):
        ones[k] = 1.0 if active[k] < m else 0.0
        direction[k] = dot(whitened[added], whitened[active[k]], n)
        for j in range(k + 1):
            gram[k, j] += kappa * ones[k] * ones[j]
    _factorise_gram(gram, count)
    _solve_gram(gram, count, ones)
    _solve_gram(gram, count, direction)
    total = moved = 0.0
    for k in range(count):
        if active[k] < m:
            total += ones[k]
            moved += direction[k]
    shift = (moved - is_model) / total if total > 0.0 else 0.0
    for k in range(count):
        direction[k] = shift * ones[k] - direction[k]
    return shift + kappa * is_model


@inlined
def dot(a: Floats, b: Floats, n: int) -> float:
    """Return the product of two vectors (n,)."""
    total = 0.0
    for i in range(n):
        total += a[i] * b[i]
    return total


@inlined
def forward(factor: Floats, n: int, right: Floats, out: Floats) -> None:
    """Solve L out = right, the diagonal inverted; both may be the same array."""
    for i in range(n):
        total = right[i]
        for k in range(i):
            total -= factor[i, k] * out[k]
        out[i] = total * factor[i, i]


@inlined
def backward(factor: Floats, n: int, right: Floats, out: Floats) -> None:
    """Solve L' out = right likewise."""
    for i in range(n - 1, -1, -1):
        total = right[i]
        for k in range(i + 1, n):
            total -= factor[k, i] * out[k]
        out[i] = total * factor[i, i]


@compiled
def _factorise_gram(gram: Floats, count: int) -> None:
    """Cholesky factor as of `cholesky`; a row that depends on the others is disabled."""
    for j in range(count):
        pivot = gram[j, j]
        for k in range(j):
            pivot -= gram[j, k] * gram[j, k]
        inverse = 1.0 / math.sqrt(pivot) if pivot > TINY * gram[j, j] else 0.0
        for i in range(j + 1, count):
            entry = gram[i, j]
            for k in range(j):
                entry -= gram[i, k] * gram[j, k]
            gram[i, j] = entry * inverse
        gram[j, j] = inverse


@compiled
def _solve_gram(gram: Floats, count: int, right: Floats) -> None:
    forward(gram, count, right, right)
    backward(gram, count, right, right)
