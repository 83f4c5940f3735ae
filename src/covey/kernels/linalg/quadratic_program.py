"""The quadratic programme of one step: maximise the minimum of linear models, less a penalty.

    maximise  z - d'Bd / 2   subject to  z <= f_s + g_s'd  for each s,   lower <= d <= upper.

A dual active-set method (Goldfarb and Idnani, 1983) on few variables. It starts from the maximiser
for one model alone, adds the constraint that is violated most, and drops constraints whose
multiplier would turn negative. The variable z has no curvature: instead, the multipliers of the
models sum to one.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints, Workspace, floats, ints, rows, wide_rows

_TINY = 1e-14


class QuadraticProgram(NamedTuple):
    """The data of a programme of n variables and m models."""

    values: Floats  # (m,) f_s
    gradients: Floats  # (m, n) g_s, or more rows and columns
    factor: Floats  # (n, n) Cholesky factor of B as `cholesky` writes it, or larger
    linear: Floats  # (n,) linear term of the objective, added to the models' gradients
    lower: Floats  # (n,)
    upper: Floats  # (n,)


class Solution(NamedTuple):
    """Where a programme is solved. Both are modified in place."""

    step: Floats  # (n,) d
    multipliers: Floats  # (m,) of the models, >= 0, summing to one


class QuadraticScratch(NamedTuple):
    """Arrays of the active-set method for n variables and up to m models."""

    whitened: Floats  # (m + 2n, n) L^-1 a_j for each constraint j
    active: Ints  # (n + 2,)
    multipliers: Floats  # (n + 2,) of the active constraints
    gram: Floats  # (n + 2, n + 2) their products, then its Cholesky factor
    ones: Floats  # (n + 2,)
    direction: Floats  # (n + 2,)
    combined: Floats  # (n,) sum of multipliers times whitened


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


class _ActiveSet(NamedTuple):
    """How many constraints are active, and z."""

    size: int
    z: float


@compiled
def solve_quadratic(
    program: QuadraticProgram, solution: Solution, scratch: QuadraticScratch
) -> float:
    """Solve the programme; return z.

    Constraints are numbered: the models 0 to m - 1, then the n lower bounds, then the n upper ones.

    1. Start with the model of the least value active alone, at its unconstrained maximiser.
    2. Find the constraint that is violated most; end if there is none.
    3. Activate it, which drops constraints whose multiplier comes to zero; repeat from 2.

    Parameters
    ----------
    program
        The data; not modified.
    solution
        (n,) step and (m,) multipliers; modified in place.
    scratch
        With room for n variables and m models; modified in place.

    Returns
    -------
    float
        z, the minimum of the models at the step.
    """
    n, m = len(program.lower), len(program.values)
    step = solution.step
    active = _start(program, scratch)
    for _ in range(20 + 8 * n):
        _backward(program.factor, n, scratch.combined, step)
        added, violation = _most_violated(program, step, active, scratch)
        if added < 0:
            break
        if added >= m:
            _unit_whitened(program.factor, n, m, added, scratch.whitened[added])
        active = _activate(n, m, added, violation, active, scratch)
    for s in range(m):
        solution.multipliers[s] = 0.0
    for k in range(active.size):
        if scratch.active[k] < m:
            solution.multipliers[scratch.active[k]] = scratch.multipliers[k]
    for i in range(n):
        step[i] = min(max(step[i], program.lower[i]), program.upper[i])
    # The sum of all steps is rounded by the size of the multipliers; the models aren't.
    z = math.inf
    for s in range(m):
        z = min(z, program.values[s] + _dot(program.gradients[s], step, n))
    return z


@inlined
def _start(program: QuadraticProgram, scratch: QuadraticScratch) -> _ActiveSet:
    """Whiten the models, and activate the model of the least value."""
    n, whitened, combined, first = len(program.lower), scratch.whitened, scratch.combined, 0
    for s in range(len(program.values)):
        _forward(program.factor, n, program.gradients[s], whitened[s])
        if program.values[s] < program.values[first]:
            first = s
    scratch.active[0], scratch.multipliers[0] = first, 1.0
    _forward(program.factor, n, program.linear, combined)
    for i in range(n):
        combined[i] += whitened[first, i]
    return _ActiveSet(1, program.values[first] + _dot(whitened[first], combined, n))


@compiled
def _activate(
    n: int,
    m: int,
    added: int,
    violation: float,
    active_set: _ActiveSet,
    scratch: QuadraticScratch,
) -> _ActiveSet:
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
    _ActiveSet
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
        full = -violation / curvature if curvature > _TINY * own else math.inf
        partial, dropped = _first_to_vanish(count, scratch)
        length = min(full, partial)
        if length == math.inf:
            return _ActiveSet(count, z)
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
    return _ActiveSet(count + 1, z)


@inlined
def _holds_model(m: int, active: Ints, count: int) -> bool:
    """Whether a model is among the active constraints."""
    models = 0
    for k in range(count):
        models += active[k] < m
    return models > 0


@inlined
def _direction_and_curvature(
    n: int, m: int, added: int, count: int, scratch: QuadraticScratch
) -> tuple[float, float, float]:
    """Write the direction; return the slopes of z and of the violation, and the row's square."""
    whitened, is_model = scratch.whitened, 1.0 if added < m else 0.0
    slope = _direction(n, m, added, is_model, count, scratch)
    curvature = -is_model * slope
    for k in range(count):
        curvature += scratch.direction[k] * _dot(whitened[added], whitened[scratch.active[k]], n)
    own = _dot(whitened[added], whitened[added], n)
    return slope, curvature + own, own


@inlined
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


@inlined
def _most_violated(
    program: QuadraticProgram, step: Floats, active_set: _ActiveSet, scratch: QuadraticScratch
) -> tuple[int, float]:
    """Return the constraint that is violated most and its slack; (-1, ...) if all hold."""
    n, m, active, count = len(step), len(program.values), scratch.active, active_set.size
    worst, added = -_TINY * (1.0 + abs(active_set.z)), -1
    for s in range(m):
        value = program.values[s] + _dot(scratch.whitened[s], scratch.combined, n)
        slack = value - active_set.z
        if slack < worst and not _is_active(s, active, count):
            worst, added = slack, s
    for i in range(n):
        below, above = step[i] - program.lower[i], program.upper[i] - step[i]
        slack = min(below, above)
        bound = m + i if below < above else m + n + i
        if slack < worst and not _is_active(bound, active, count):
            worst, added = slack, bound
    return added, worst


@inlined
def _is_active(constraint: int, active: Ints, count: int) -> bool:
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
    """Cholesky factor as of `cholesky`; a row that depends on the others is disabled."""
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
