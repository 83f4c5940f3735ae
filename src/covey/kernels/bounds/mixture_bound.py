"""A proven bound on how late the last capture can come if the first capture alone is announced.

The maximum of a mean over orders is attained at corners of polygons around the velocities until the
first capture (docs/decisions/0018). A search through these corners, one evader after the other,
finds an upper bound of that maximum.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry
from covey.kernels.arrays import IntVector, Matrix, Tensor, Vector
from covey.kernels.bounds.corner_programme import latest_at_corners
from covey.kernels.bounds.mixture import (
    Mixture,
    MixtureScratch,
    copy,
    copy_attained,
    fly,
    refine,
)
from covey.kernels.capture.path import X, Y
from covey.kernels.capture.pursuit import GrowingDisk

_ROUGHLY = 1e-4
"""Relative gain of a step at which headings show where the corners need to be dense."""

_ELSEWHERE = 0.5
"""Radians from where the corners are dense, beyond which a bound is computed again."""


class Branches(NamedTuple):
    """A search through the corners of the velocities until the first capture.

    A branch is a corner for each of the first evaders, with half the angle that it stands for. The
    stack holds the branches that are still to be bounded.
    """

    corners: int  # of the first polygon
    finest: float  # radians; a corner that stands for less to each side is not divided
    most: int  # branches that are bounded, at most
    fixed: IntVector  # (stack,) evaders whose corner is fixed
    directions: Matrix  # (stack, n)
    halves: Matrix  # (stack, n)
    headings: Tensor  # (stack, m, n)


@compiled
def _upper_bound(mixture: Mixture, disk: GrowingDisk, s: int, scratch: MixtureScratch) -> float:
    """Return an upper bound of the last capture in an order, whatever is not known yet.

    Where the bound is attained far from the headings that the corners are dense around, it is
    computed again around those that attain it.
    """
    programme, headings = scratch.programme, scratch.headings[s]
    reach, order = mixture.pursuit.first_radius, mixture.orders[s]
    bound = math.inf
    for _ in range(2):
        refine(mixture, disk, s, _ROUGHLY, scratch)
        latest = latest_at_corners(
            scratch.departed, scratch.departures, disk, reach, order, headings, programme
        )
        bound = min(bound, latest)
        off = 0.0
        for k in range(len(order)):
            off = max(off, abs(programme.attained[order[k]] - headings[order[k]]))
        if off < _ELSEWHERE:
            break
        copy_attained(order, programme, headings)
    return bound


@compiled
def _mean_bound(mixture: Mixture, disk: GrowingDisk, scratch: MixtureScratch) -> float:
    """Return the mean of the upper bounds of all orders."""
    mean = 0.0
    for s in range(len(mixture.orders)):
        mean += mixture.weights[s] * _upper_bound(mixture, disk, s, scratch)
    return mean


@entry
def mixture_bound(
    mixture: Mixture, target: float, branches: Branches, attained: Vector, scratch: MixtureScratch
) -> tuple[float, int]:
    """Return an upper bound of the mean over the orders, and how many branches were bounded.

    1. Bound the mean where the pursuer starts from the first evader: below it the mean need not be
       quasi-convex in the velocities.
    2. Take a branch from the stack, and bound it. Below the target it needs no further look.
    3. Otherwise divide its last corner in two, and when that is fine, put the corners of the next
       evader on the stack. A branch in which all corners are fixed ends the search.

    Parameters
    ----------
    mixture
        The orders and their weights. The search fixes the evaders' corners in the order of rows.
    target
        Time; the search ends with a bound that is at most this, or at the first headings that may
        be above it.
    branches
        Modified in place.
    attained
        (n,) headings until the first capture that may be above the target; modified in place.
    scratch
        Modified in place.

    Returns
    -------
    float
        Whatever the evaders do, the mean is at most this if this is at most the target. Else the
        target may be exceeded, at `attained`; inf if the branches were used up.
    int
    """
    bound = _from_first_evader(mixture, scratch)
    half = math.pi / branches.corners
    used = _push(branches, 0, branches.corners, 0, 0.0, half, scratch)
    for bounded in range(branches.most):
        if bound > target or used == 0:
            return bound, bounded
        used -= 1
        fixed = branches.fixed[used]
        value = _branch_bound(mixture, branches, used, scratch)
        own = branches.halves[used, fixed]
        if value <= target:
            bound = max(bound, value)
        elif own > branches.finest:
            first = branches.directions[used, fixed] - 0.5 * own
            used = _push(branches, used, 2, fixed, first, 0.5 * own, scratch)
        elif fixed + 1 < len(attained):
            used = _push(branches, used, branches.corners, fixed + 1, 0.0, half, scratch)
        else:
            copy(scratch.directions, attained)
            return value, bounded + 1
    return math.inf, branches.most


@compiled
def _from_first_evader(mixture: Mixture, scratch: MixtureScratch) -> float:
    """Return an upper bound of the mean if the pursuer has captured the first evader at time 0."""
    x, y = mixture.evaders[0, X], mixture.evaders[0, Y]
    for i in range(len(mixture.evaders)):
        away = math.atan2(mixture.evaders[i, Y] - y, mixture.evaders[i, X] - x)
        scratch.headings[:, i] = away
        copy(mixture.evaders[i], scratch.departed[i])
        copy(mixture.evaders[i], scratch.here[i])
        scratch.departures[i] = 0.0
    return _mean_bound(mixture, GrowingDisk(x, y, 0.0, 0.0, mixture.pursuit.speed), scratch)


@compiled
def _branch_bound(mixture: Mixture, branches: Branches, row: int, scratch: MixtureScratch) -> float:
    """Return an upper bound of the mean if the first evaders fly to the corners of a branch."""
    fixed = branches.fixed[row]
    for s in range(len(mixture.orders)):
        copy(branches.headings[row, s], scratch.headings[s])
    for i in range(fixed + 1):
        scratch.directions[i] = branches.directions[row, i]
        scratch.stretches[i] = 1.0 / math.cos(branches.halves[row, i])
    return _mean_bound(mixture, fly(mixture, fixed + 1, scratch), scratch)


@compiled
def _push(
    branches: Branches,
    row: int,
    count: int,
    fixed: int,
    first: float,
    half: float,
    scratch: MixtureScratch,
) -> int:
    """Put `count` corners of one evader on the stack; return how many branches it holds then.

    Parameters
    ----------
    branches
        Modified in place from `row` on, where the branch is whose other corners are kept.
    row, count
        The first row that is written, and how many are.
    fixed
        The evader, and how many are fixed before it.
    first, half
        Direction of the first corner, and half the angle to the next one, radians.
    scratch
        Its `headings` become those of the branches.
    """
    for j in range(count):
        branches.fixed[row + j] = fixed
        for i in range(fixed):
            branches.directions[row + j, i] = branches.directions[row, i]
            branches.halves[row + j, i] = branches.halves[row, i]
        branches.directions[row + j, fixed] = first + 2.0 * half * j
        branches.halves[row + j, fixed] = half
        for s in range(len(scratch.headings)):
            copy(scratch.headings[s], branches.headings[row + j, s])
    return row + count
