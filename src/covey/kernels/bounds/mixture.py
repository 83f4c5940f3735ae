"""The mean last capture over orders, after a first capture that is announced, and its local maxima.

After the first capture the pursuer goes on in the order that is best then. A mean over orders, with
weights that are fixed, is no less than their minimum (docs/decisions/0018).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, IntMatrix, Ints, Matrix, Tensor, Vector
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
    copy(headings, scratch.directions)
    for s in range(len(mixture.orders)):
        copy(headings, scratch.headings[s])
    best = -math.inf
    for _ in range(_MOST_STEPS):
        disk = fly(mixture, len(headings), scratch)
        mean = 0.0
        for s in range(len(mixture.orders)):
            if mixture.weights[s] > 0.0:
                mean += mixture.weights[s] * _local_maximum(mixture, disk, s, scratch)
        if mean - best <= _SETTLED * mean:
            break
        best = mean
        copy(scratch.directions, headings)
        _turn(mixture, scratch)
    copy(headings, scratch.directions)
    disk = fly(mixture, len(headings), scratch)
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
def fly(mixture: Mixture, fixed: int, scratch: MixtureScratch) -> GrowingDisk:
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
        copy(evaders[i], here[i])
        here[i, X], here[i, Y] = x + velocity_x * time, y + velocity_y * time
        scratch.departures[i] = time if known else 0.0
        copy(here[i] if known else evaders[i], departed[i])
    return GrowingDisk(here[0, X], here[0, Y], 0.0, time, pursuer.speed)


@compiled
def _local_maximum(mixture: Mixture, disk: GrowingDisk, s: int, scratch: MixtureScratch) -> float:
    """Return the last capture in an order from `here`, at the best headings; write its gradient."""
    programme, headings = scratch.programme, scratch.headings[s]
    reach, order = mixture.pursuit.first_radius, mixture.orders[s]
    latest_at_corners(scratch.departed, scratch.departures, disk, reach, order, headings, programme)
    copy_attained(order, programme, headings)
    latest = refine(mixture, disk, s, _SETTLED, scratch)
    turn_along_gradient(order, headings, scratch.flights)
    for k in range(len(order)):
        scratch.gradients[s, order[k], 0] = scratch.flights[k, GRADIENT_X]
        scratch.gradients[s, order[k], 1] = scratch.flights[k, GRADIENT_Y]
    return latest


@compiled
def refine(
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
def copy_attained(order: Ints, programme: CornerProgramme, headings: Floats) -> None:
    """Copy the headings that attain the programme's bound."""
    for k in range(len(order)):
        headings[order[k]] = programme.attained[order[k]]


@inlined
def copy(source: Floats, target: Floats) -> None:
    """Copy a vector; a kernel can't assign one to a slice, for that allocates."""
    for i in range(len(source)):
        target[i] = source[i]
