"""How late the last capture can come if the pursuer announces its first capture alone.

After the first capture the pursuer goes on in the order that is best then. A mean over orders, with
weights that are fixed, is no less than their minimum, and its maximum over all flights is attained
at corners of polygons around the velocities until the first capture (docs/decisions/0018). A search
through these corners, one evader after the other, finds an upper bound of that maximum.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, IntMatrix, Ints, IntVector, Matrix, Tensor, Vector
from covey.kernels.bounds.announced_sequences import (
    GRADIENT_X,
    GRADIENT_Y,
    raise_lower_bound,
    turn_along_gradient,
)
from covey.kernels.bounds.corner_programme import CornerProgramme, latest_at_corners
from covey.kernels.capture.path import SPEED, X, Y
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.capture.straight_legs import capture_on_line

_MOST_STEPS = 60

_SETTLED = 1e-7
"""Relative gain of a step at which a mean is taken to be the maximum."""

_ROUGHLY = 1e-4
"""The same, where a maximum shows only where the corners need to be dense."""

_ELSEWHERE = 0.5
"""Radians from where the corners are dense, beyond which a bound is computed again."""


class Mixture(NamedTuple):
    """Orders in which the pursuer may go on after its first capture, and their weights."""

    evaders: Matrix  # (n, EVADER); the first one is captured first
    pursuit: Pursuit  # from a point; `first_radius` counts for the last capture only
    orders: IntMatrix  # (m, n - 1) of the evaders 1 to n - 1
    weights: Vector  # (m,) >= 0, summing to one


class MixtureScratch(NamedTuple):
    """Arrays for a mixture: flights until the first capture, and after it."""

    directions: Vector  # (n,) until the first capture
    stretches: Vector  # (n,) speed until then, over the evader's own
    departed: Matrix  # (n, EVADER) where what is known of the flights ends
    departures: Vector  # (n,) and when
    here: Matrix  # (n, EVADER) at the first capture
    headings: Matrix  # (m, n) after it, by order
    flights: Matrix  # (n, FLIGHT)
    gradients: Tensor  # (m, n, 2) of the last capture by the positions at the first one
    programme: CornerProgramme


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


@entry
def climb_mixture(
    mixture: Mixture, headings: Vector, values: Vector, scratch: MixtureScratch
) -> float:
    """Raise the mean over the orders by better headings until the first capture; return it.

    The mean is quasi-convex in all velocities together, so all evaders turn to where the gradient
    points.

    Parameters
    ----------
    mixture
        The orders and their weights.
    headings
        (n,) radians, by evader, until the first capture; modified in place.
    values
        (m,) last captures at these headings, by order; modified in place.
    scratch
        Modified in place; has the gradients at these headings.
    """
    scratch.stretches[:] = 1.0
    _copy(headings, scratch.directions)
    for s in range(len(mixture.orders)):
        _copy(headings, scratch.headings[s])
    best = -math.inf
    for _ in range(_MOST_STEPS):
        disk = _fly(mixture, len(headings), scratch)
        mean = 0.0
        for s in range(len(mixture.orders)):
            if mixture.weights[s] > 0.0:
                mean += mixture.weights[s] * _local_maximum(mixture, disk, s, scratch)
        if mean - best <= _SETTLED * mean:
            break
        best = mean
        _copy(scratch.directions, headings)
        _turn(mixture, scratch)
    _copy(headings, scratch.directions)
    disk = _fly(mixture, len(headings), scratch)
    for s in range(len(mixture.orders)):
        values[s] = _local_maximum(mixture, disk, s, scratch)
    return best


@compiled
def _turn(mixture: Mixture, scratch: MixtureScratch) -> None:
    """Turn all `directions` to where the gradient of the mean by the velocities points.

    A later first capture delays all that follows, and moves the others along their flights.
    """
    here, directions = scratch.here, scratch.directions
    pursuit, speed = mixture.pursuit, mixture.evaders[0, SPEED]
    velocity_x, velocity_y = speed * math.cos(directions[0]), speed * math.sin(directions[0])
    start_x = start_y = 0.0
    delay = 1.0
    for k in range(1, len(directions)):
        speed = mixture.evaders[k, SPEED]
        x, y = speed * math.cos(directions[k]), speed * math.sin(directions[k])
        gradient_x = gradient_y = 0.0
        for s in range(len(mixture.orders)):
            gradient_x += mixture.weights[s] * scratch.gradients[s, k, 0]
            gradient_y += mixture.weights[s] * scratch.gradients[s, k, 1]
        delay += gradient_x * (x - velocity_x) + gradient_y * (y - velocity_y)
        start_x, start_y = start_x - gradient_x, start_y - gradient_y
        if gradient_x != 0.0 or gradient_y != 0.0:
            directions[k] = math.atan2(gradient_y, gradient_x)
    way_x, way_y = here[0, X] - pursuit.center_x, here[0, Y] - pursuit.center_y
    way = math.hypot(way_x, way_y)
    if way > 0.0:
        way_x, way_y = way_x / way, way_y / way
        delay /= pursuit.speed - way_x * velocity_x - way_y * velocity_y
        directions[0] = math.atan2(delay * way_y + start_y, delay * way_x + start_x)


@compiled
def _fly(mixture: Mixture, fixed: int, scratch: MixtureScratch) -> GrowingDisk:
    """Write where the evaders are at the first capture; return the pursuer then.

    The first evaders fly to their corners until the first capture. What the others do is not known:
    `here` guesses that they fly on along their headings in the first order.
    """
    evaders, departed, here = mixture.evaders, scratch.departed, scratch.here
    pursuer = GrowingDisk(
        mixture.pursuit.center_x, mixture.pursuit.center_y, 0.0, 0.0, mixture.pursuit.speed
    )
    time = 0.0
    for i in range(len(evaders)):
        known = i < fixed
        direction = scratch.directions[i] if known else scratch.headings[0, i]
        speed = evaders[i, SPEED] * (scratch.stretches[i] if known else 1.0)
        velocity_x, velocity_y = speed * math.cos(direction), speed * math.sin(direction)
        x, y = evaders[i, X], evaders[i, Y]
        if i == 0:
            closing = (pursuer.speed - speed) * (pursuer.speed + speed)
            time = capture_on_line(x, y, velocity_x, velocity_y, closing, pursuer)
        _copy(evaders[i], here[i])
        here[i, X], here[i, Y] = x + velocity_x * time, y + velocity_y * time
        scratch.departures[i] = time if known else 0.0
        _copy(here[i] if known else evaders[i], departed[i])
    return GrowingDisk(here[0, X], here[0, Y], 0.0, time, pursuer.speed)


@compiled
def _local_maximum(mixture: Mixture, disk: GrowingDisk, s: int, scratch: MixtureScratch) -> float:
    """Return the last capture in an order from `here`, at the best headings; write its gradient."""
    programme, headings = scratch.programme, scratch.headings[s]
    reach, order = mixture.pursuit.first_radius, mixture.orders[s]
    latest_at_corners(scratch.departed, scratch.departures, disk, reach, order, headings, programme)
    _copy_attained(order, programme, headings)
    latest = _refine(mixture, disk, s, _SETTLED, scratch)
    turn_along_gradient(order, headings, scratch.flights)
    for k in range(len(order)):
        scratch.gradients[s, order[k], 0] = scratch.flights[k, GRADIENT_X]
        scratch.gradients[s, order[k], 1] = scratch.flights[k, GRADIENT_Y]
    return latest


@compiled
def _refine(
    mixture: Mixture, disk: GrowingDisk, s: int, settled: float, scratch: MixtureScratch
) -> float:
    """Improve the headings in an order from `here`; return the last capture."""
    pursuit = Pursuit(disk.x, disk.y, mixture.pursuit.first_radius, 0.0, disk.speed)
    return disk.time + raise_lower_bound(
        scratch.here,
        pursuit,
        math.inf,
        settled,
        mixture.orders[s],
        scratch.headings[s],
        scratch.flights,
    )


@compiled
def _copy_attained(order: Ints, programme: CornerProgramme, headings: Floats) -> None:
    """Copy the headings that attain the programme's bound."""
    for k in range(len(order)):
        headings[order[k]] = programme.attained[order[k]]


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
        _refine(mixture, disk, s, _ROUGHLY, scratch)
        latest = latest_at_corners(
            scratch.departed, scratch.departures, disk, reach, order, headings, programme
        )
        bound = min(bound, latest)
        off = 0.0
        for k in range(len(order)):
            off = max(off, abs(programme.attained[order[k]] - headings[order[k]]))
        if off < _ELSEWHERE:
            break
        _copy_attained(order, programme, headings)
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
            _copy(scratch.directions, attained)
            return value, bounded + 1
    return math.inf, branches.most


@compiled
def _from_first_evader(mixture: Mixture, scratch: MixtureScratch) -> float:
    """Return an upper bound of the mean if the pursuer has captured the first evader at time 0."""
    x, y = mixture.evaders[0, X], mixture.evaders[0, Y]
    for i in range(len(mixture.evaders)):
        away = math.atan2(mixture.evaders[i, Y] - y, mixture.evaders[i, X] - x)
        scratch.headings[:, i] = away
        _copy(mixture.evaders[i], scratch.departed[i])
        _copy(mixture.evaders[i], scratch.here[i])
        scratch.departures[i] = 0.0
    return _mean_bound(mixture, GrowingDisk(x, y, 0.0, 0.0, mixture.pursuit.speed), scratch)


@compiled
def _branch_bound(mixture: Mixture, branches: Branches, row: int, scratch: MixtureScratch) -> float:
    """Return an upper bound of the mean if the first evaders fly to the corners of a branch."""
    fixed = branches.fixed[row]
    for s in range(len(mixture.orders)):
        _copy(branches.headings[row, s], scratch.headings[s])
    for i in range(fixed + 1):
        scratch.directions[i] = branches.directions[row, i]
        scratch.stretches[i] = 1.0 / math.cos(branches.halves[row, i])
    return _mean_bound(mixture, _fly(mixture, fixed + 1, scratch), scratch)


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
            _copy(scratch.headings[s], branches.headings[row + j, s])
    return row + count


@inlined
def _copy(source: Floats, target: Floats) -> None:
    """Copy a vector; a kernel can't assign one to a slice, for that allocates."""
    for i in range(len(source)):
        target[i] = source[i]
