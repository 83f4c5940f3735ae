"""The Hessian of the local model: convexified or modified to be factored, and its escapes.

An escape is a step off a saddle or a plateau, where no gradient says how the value rises.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats
from covey.kernels.linalg.symmetric import cholesky, jacobi_eigen, make_positive
from covey.kernels.maximum.ascent.local_model import ModelScratch
from covey.kernels.maximum.working_set import WorkingSet

_PENALTY = 20.0  # of the Hessian's size, across the active sequences
FARTHEST = 1e5  # radians to the maximum of a single sequence's model, at most
_CHANGED, _NEGLIGIBLE = 0.1, 1e-6  # of the multipliers, which sum to one
_ESCAPE_LENGTH = 0.03  # radians


class HessianStatus(NamedTuple):
    """How the Hessian was changed before it was factored."""

    convexified: bool  # by the penalty, which leaves the maximiser where it is
    modified: bool  # eigenvalues replaced by their absolute values


@compiled
def factor_hessian(
    n: int,
    working_set: WorkingSet,
    values: Floats,
    convexify: bool,
    scale: float,
    scratch: ModelScratch,
) -> HessianStatus:
    """Factor the Hessian for the quadratic programme; convexify or modify it where that is needed.

    1. Where the Hessian is positive definite (its sign is turned), it is factored as it is.
    2. With `convexify`, an augmented Lagrangian follows: a penalty on the differences of the active
       sequences' models. These differences decide the step along the differences of the gradients,
       whatever the Hessian is there, so the maximiser doesn't move and Newton's method stays
       quadratic.
    3. Where the Hessian still has a wrong sign, its eigenvalues are replaced by their absolute
       values, which is slow but safe.

    Pivots stay above max|g| / 1e5, so no single model's maximiser lies farther than 1e5 rad. Beyond
    that, rounding swallows the predicted gain.

    Parameters
    ----------
    n
        Number of turns.
    working_set
        Its multipliers say which sequences are active.
    values
        (m,) objective of each sequence.
    convexify
        Whether step 2 is tried.
    scale
        Power of two that the times are multiplied by.
    scratch
        Holds the gradients and the Hessian. Modified in place: `factor`, `linear`,
        `convex_hessian`, `step`, `eigenvectors`, `eigenvalues`.
    """
    steepest = 0.0
    for i in range(n):
        scratch.linear[i] = 0.0
        for s in range(working_set.used[0]):
            steepest = max(steepest, abs(scratch.gradients[s, i]))
    floor = steepest / FARTHEST
    if cholesky(scratch.hessian, n, floor, scratch.factor):
        return HessianStatus(False, False)
    _copy_hessian(n, scratch)
    convexified = convexify and penalise(n, working_set, values, scale, scratch)
    if cholesky(scratch.convex_hessian, n, floor, scratch.factor):
        return HessianStatus(convexified, False)
    make_positive(scratch.convex_hessian, n, floor, scratch.eigenvectors, scratch.eigenvalues)
    cholesky(scratch.convex_hessian, n, 0.0, scratch.factor)
    return HessianStatus(convexified, True)


@compiled
def multipliers_changed(working_set: WorkingSet, scratch: ModelScratch) -> bool:
    """Return whether the last step's multipliers differ from those that weight the Hessian."""
    change = 0.0
    for s in range(working_set.used[0]):
        change += abs(working_set.weights[s] - scratch.weights[s])
    return change > _CHANGED


@compiled
def escape_count(
    n: int, working_set: WorkingSet, values: Floats, scale: float, scratch: ModelScratch
) -> int:
    """Return how many escapes there are to try, see `escape_step`.

    None where the Hessian is negative definite along the active sequences: the turns are neither a
    saddle nor on a plateau. Else the direction of most positive curvature is written to
    `scratch.eigenvalues`.
    """
    if cholesky(scratch.hessian, n, 0.0, scratch.factor):
        return 0
    _copy_hessian(n, scratch)
    penalise(n, working_set, values, scale, scratch)
    if cholesky(scratch.convex_hessian, n, 0.0, scratch.factor):
        return 0
    jacobi_eigen(scratch.convex_hessian, n, scratch.eigenvectors)
    upwards = 0
    for k in range(n):
        if scratch.convex_hessian[k, k] < scratch.convex_hessian[upwards, upwards]:
            upwards = k
    for i in range(n):
        scratch.eigenvalues[i] = scratch.eigenvectors[i, upwards]
    return 2 * n + 2


@inlined
def escape_step(escape: int, n: int, scratch: ModelScratch) -> None:
    """Write an escape: one turn alone, to either side; last, the direction of positive curvature.

    On a plateau, where an evader is caught while it turns, no curvature says which turn to change.
    """
    length = _ESCAPE_LENGTH if escape % 2 == 0 else -_ESCAPE_LENGTH
    for i in range(n):
        alone = 1.0 if i == escape // 2 else 0.0
        scratch.step[i] = length * (alone if escape < 2 * n else scratch.eigenvalues[i])


@inlined
def _copy_hessian(n: int, scratch: ModelScratch) -> None:
    for i in range(n):
        for j in range(i + 1):
            scratch.convex_hessian[i, j] = scratch.hessian[i, j]


@compiled
def penalise(
    n: int, working_set: WorkingSet, values: Floats, scale: float, scratch: ModelScratch
) -> bool:
    """Add the penalty on differing active models to the Hessian and the linear term.

    Returns False where no two active gradients differ. The models are compared with the model of
    the largest multiplier. Measured from the weighted mean, that model would differ by almost
    nothing; the penalty divides by the smallest difference squared, and would block every step.
    """
    gradients, weights, difference = scratch.gradients, working_set.weights, scratch.step
    heaviest, penalty = _heaviest_and_penalty(n, working_set, scratch)
    if penalty == math.inf:
        return False
    for s in range(working_set.used[0]):
        if weights[s] > _NEGLIGIBLE and s != heaviest:
            excess = scale * (values[s] - values[heaviest])
            for i in range(n):
                difference[i] = gradients[s, i] - gradients[heaviest, i]
                scratch.linear[i] -= penalty * difference[i] * excess
                for j in range(i + 1):
                    scratch.convex_hessian[i, j] += penalty * difference[i] * difference[j]
    return True


@inlined
def _heaviest_and_penalty(
    n: int, working_set: WorkingSet, scratch: ModelScratch
) -> tuple[int, float]:
    """Return the sequence of the largest multiplier, and the penalty's factor; inf: no penalty."""
    gradients, weights, count = scratch.gradients, working_set.weights, working_set.used[0]
    heaviest, size, shortest = 0, 0.0, math.inf
    for i in range(n):
        for j in range(i + 1):
            size = max(size, abs(scratch.convex_hessian[i, j]))
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
    return heaviest, _PENALTY * size / shortest if shortest < math.inf else math.inf
