"""The quadratic programme of one step: maximise the minimum of linear models, less a penalty.

    maximise  z - d'Bd / 2   subject to  z <= f_s + g_s'd  for each s,   lower <= d <= upper.

A dual active-set method (Goldfarb and Idnani, 1983) on few variables, see `active_set`. It starts
from the maximiser for one model alone, adds the constraint that is violated most, and drops
constraints whose multiplier would turn negative. The variable z has no curvature: instead, the
multipliers of the models sum to one.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints
from covey.kernels.linalg.active_set import (
    TINY,
    ActiveSet,
    QuadraticScratch,
    activate,
    backward,
    dot,
    forward,
)


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
        backward(program.factor, n, scratch.combined, step)
        added, violation = _most_violated(program, step, active, scratch)
        if added < 0:
            break
        if added >= m:
            _unit_whitened(program.factor, n, m, added, scratch.whitened[added])
        active = activate(n, m, added, violation, active, scratch)
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
        z = min(z, program.values[s] + dot(program.gradients[s], step, n))
    return z


@inlined
def _start(program: QuadraticProgram, scratch: QuadraticScratch) -> ActiveSet:
    """Whiten the models, and activate the model of the least value."""
    n, whitened, combined, first = len(program.lower), scratch.whitened, scratch.combined, 0
    for s in range(len(program.values)):
        forward(program.factor, n, program.gradients[s], whitened[s])
        if program.values[s] < program.values[first]:
            first = s
    scratch.active[0], scratch.multipliers[0] = first, 1.0
    forward(program.factor, n, program.linear, combined)
    for i in range(n):
        combined[i] += whitened[first, i]
    return ActiveSet(1, program.values[first] + dot(whitened[first], combined, n))


@inlined
def _most_violated(
    program: QuadraticProgram, step: Floats, active_set: ActiveSet, scratch: QuadraticScratch
) -> tuple[int, float]:
    """Return the constraint that is violated most and its slack; (-1, ...) if all hold."""
    n, m, active, count = len(step), len(program.values), scratch.active, active_set.size
    worst, added = -TINY * (1.0 + abs(active_set.z)), -1
    for s in range(m):
        value = program.values[s] + dot(scratch.whitened[s], scratch.combined, n)
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
    forward(factor, n, out, out)
