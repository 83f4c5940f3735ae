"""The quadratic programme of one step: maximise the least of a few linear models, less a penalty.

    maximise  z - d'Bd / 2   subject to  z <= f_s + g_s'd  for each s,   low <= d <= high.

A dual active-set method (Goldfarb and Idnani, 1983) on its few variables: start from the maximiser
for one model alone, add the constraint that is violated most, drop those whose multiplier would
turn negative. The variable z has no curvature; the multipliers of the models sum to one instead.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Ints

_TINY = 1e-14


class QuadraticScratch(NamedTuple):
    """Arrays of the active-set method for n variables and up to m models."""

    whitened: Floats  # (m + 2n, n) L^-1 a_j for each constraint j
    active: Ints  # (n + 2,)
    multipliers: Floats  # (n + 2,) of the active constraints
    gram: Floats  # (n + 2, n + 2) their products, then its Cholesky factor
    ones: Floats  # (n + 2,)
    direction: Floats  # (n + 2,)
    combined: Floats  # (n,) sum of multipliers times whitened


@allocating
def quadratic_scratch(n: int, m: int) -> QuadraticScratch:
    """Allocate the scratch of `solve_quadratic`."""
    return QuadraticScratch(
        np.empty((m + 2 * n, n)),
        np.empty(n + 2, np.int64),
        np.empty(n + 2),
        np.empty((n + 2, n + 2)),
        np.empty(n + 2),
        np.empty(n + 2),
        np.empty(n),
    )


@compiled
def solve_quadratic(
    n: int,
    m: int,
    values: Floats,
    gradients: Floats,
    factor: Floats,
    pull: Floats,
    low: Floats,
    high: Floats,
    step: Floats,
    weights: Floats,
    scratch: QuadraticScratch,
) -> float:
    """Write the maximising `step` and the models' multipliers `weights`; return z.

    `factor` is the Cholesky factor of B as `factorise` writes it. The constraints are the models
    0..m-1, then the lower bounds, then the upper ones.
    """
    whitened, active, multipliers = scratch.whitened, scratch.active, scratch.multipliers
    for s in range(m):
        _forward(factor, n, gradients[s], whitened[s])
    first = 0
    for s in range(m):
        weights[s] = 0.0
        if values[s] < values[first]:
            first = s
    active[0], multipliers[0], count = first, 1.0, 1
    combined = scratch.combined
    _forward(factor, n, pull, combined)
    for i in range(n):
        combined[i] += whitened[first, i]
    least = values[first] + _dot(whitened[first], combined, n)

    for _ in range(20 + 8 * n):
        _backward(factor, n, combined, step)
        added, violation = _most_violated(
            n, m, values, whitened, combined, step, low, high, active, count, least
        )
        if added < 0:
            break
        if added >= m:
            _unit_whitened(factor, n, m, added, whitened[added])
        count, least = _activate(n, m, added, violation, count, least, scratch)
    for k in range(count):
        if active[k] < m:
            weights[active[k]] = multipliers[k]
    for i in range(n):
        step[i] = min(max(step[i], low[i]), high[i])
    # What the steps added up to is rounded by the size of the multipliers; the models aren't.
    least = math.inf
    for s in range(m):
        least = min(least, values[s] + _dot(gradients[s], step, n))
    return least


@compiled
def _activate(
    n: int,
    m: int,
    added: int,
    violation: float,
    count: int,
    least: float,
    scratch: QuadraticScratch,
) -> tuple[int, float]:
    """Raise the multiplier of constraint `added` until it holds; drop those that come to zero.

    Returns the number of active constraints and z.
    """
    whitened, active, multipliers = scratch.whitened, scratch.active, scratch.multipliers
    direction, combined = scratch.direction, scratch.combined
    raised, is_model = 0.0, 1.0 if added < m else 0.0
    while count < n + 2:
        models = 0
        for k in range(count):
            models += active[k] < m
        if models == 0 and added < m:
            least += violation  # no model holds z any more: lower it to the one that is added
            break
        slope = _direction(n, m, added, is_model, count, scratch)
        curvature = -is_model * slope
        for k in range(count):
            curvature += direction[k] * _dot(whitened[added], whitened[active[k]], n)
        own = _dot(whitened[added], whitened[added], n)
        curvature += own
        full = -violation / curvature if curvature > _TINY * own else math.inf
        partial, dropped = math.inf, -1
        for k in range(count):
            if direction[k] < 0.0 and -multipliers[k] / direction[k] < partial:
                partial, dropped = -multipliers[k] / direction[k], k
        length = min(full, partial)
        if length == math.inf:
            return count, least  # dependent constraints: nothing left to gain
        raised += length
        least += length * slope
        violation += length * curvature
        for i in range(n):
            combined[i] += length * whitened[added, i]
        for k in range(count):
            multipliers[k] += length * direction[k]
            for i in range(n):
                combined[i] += length * direction[k] * whitened[active[k], i]
        if full <= partial:
            break
        count -= 1
        active[dropped], multipliers[dropped] = active[count], multipliers[count]
    active[count], multipliers[count] = added, raised
    return count + 1, least


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
            gram[k, j] = _dot(whitened[active[k]], whitened[active[j]], n)
        if active[k] < m:
            kappa = max(kappa, gram[k, k])
    if kappa == 0.0:
        kappa = 1.0
    for k in range(count):
        ones[k] = 1.0 if active[k] < m else 0.0
        direction[k] = _dot(whitened[added], whitened[active[k]], n)
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


@compiled
def _most_violated(
    n: int,
    m: int,
    values: Floats,
    whitened: Floats,
    combined: Floats,
    step: Floats,
    low: Floats,
    high: Floats,
    active: Ints,
    count: int,
    least: float,
) -> tuple[int, float]:
    """The constraint that is violated most and by how much, (-1, 0) if all hold."""
    worst, added = -_TINY * (1.0 + abs(least)), -1
    for s in range(m):
        slack = values[s] + _dot(whitened[s], combined, n) - least
        if slack < worst and not _holds(s, active, count):
            worst, added = slack, s
    for i in range(n):
        slack = min(step[i] - low[i], high[i] - step[i])
        bound = m + i if step[i] - low[i] < high[i] - step[i] else m + n + i
        if slack < worst and not _holds(bound, active, count):
            worst, added = slack, bound
    return added, worst


@inlined
def _holds(constraint: int, active: Ints, count: int) -> bool:
    for k in range(count):
        if active[k] == constraint:
            return True
    return False


@inlined
def _unit_whitened(factor: Floats, n: int, m: int, bound: int, out: Floats) -> None:
    """L^-1 a of a bound: a is +e_i for the lower one of variable i and -e_i for the upper one."""
    i, sign = bound - m, 1.0
    if i >= n:
        i, sign = i - n, -1.0
    for j in range(n):
        out[j] = 0.0
    out[i] = sign
    _forward(factor, n, out, out)


@inlined
def _dot(a: Floats, b: Floats, n: int) -> float:
    total = 0.0
    for i in range(n):
        total += a[i] * b[i]
    return total


@inlined
def _forward(factor: Floats, n: int, right: Floats, out: Floats) -> None:
    """Solve L out = right, the diagonal inverted; both may be the same array."""
    for i in range(n):
        total = right[i]
        for k in range(i):
            total -= factor[i, k] * out[k]
        out[i] = total * factor[i, i]


@inlined
def _backward(factor: Floats, n: int, right: Floats, out: Floats) -> None:
    """Solve L' out = right likewise."""
    for i in range(n - 1, -1, -1):
        total = right[i]
        for k in range(i + 1, n):
            total -= factor[k, i] * out[k]
        out[i] = total * factor[i, i]


@compiled
def _factorise_gram(gram: Floats, count: int) -> None:
    """Cholesky factor as of `factorise`; a row that depends on the others is disabled."""
    for j in range(count):
        pivot = gram[j, j]
        for k in range(j):
            pivot -= gram[j, k] * gram[j, k]
        inverse = 1.0 / math.sqrt(pivot) if pivot > _TINY * gram[j, j] else 0.0
        for i in range(j + 1, count):
            entry = gram[i, j]
            for k in range(j):
                entry -= gram[i, k] * gram[j, k]
            gram[i, j] = entry * inverse
        gram[j, j] = inverse


@compiled
def _solve_gram(gram: Floats, count: int, right: Floats) -> None:
    _forward(gram, count, right, right)
    _backward(gram, count, right, right)
