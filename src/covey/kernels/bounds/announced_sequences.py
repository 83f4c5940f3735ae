"""Lower bounds of the latest last captures in many known sequences, for unlimited turn rates.

The last capture at any headings is a lower bound of its maximum. The maximum is raised by the
conditional gradient method: the last capture is quasi-convex in each evader's velocity
(docs/decisions/0006), so each evader turns to where the gradient points.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, entry
from covey.kernels.arrays import Floats, IntMatrix, Ints, Matrix, Vector
from covey.kernels.capture.path import SPEED, X, Y
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.capture.straight_legs import capture_on_line

# A flight of the pursuer is a row (direction, closing speeds on the evader ahead and behind,
# gradient of the last capture by the position of the evader ahead).
TOWARDS_X, TOWARDS_Y, AHEAD, BEHIND, GRADIENT_X, GRADIENT_Y = range(6)
FLIGHT = 6

_MOST_STEPS = 60

_SETTLED = 1e-10
"""Relative gain of a step at which a bound is taken to be the maximum."""


@entry
def raise_lower_bounds(
    evaders: Matrix,
    pursuit: Pursuit,
    cutoff: float,
    sequences: IntMatrix,
    headings: Matrix,
    bounds: Vector,
    flights: Matrix,
) -> None:
    """Raise the lower bound of each sequence by better headings, until it reaches the cutoff.

    Parameters
    ----------
    evaders
        (n, EVADER) rows of `Team.as_rows`; headings and turn rates are not used.
    pursuit
        A pursuer at a point. It flies to each evader's exact position; `first_radius`, its reach,
        counts for the last capture only.
    cutoff
        Time at which a bound is high enough.
    sequences
        (m, n) orders of capture.
    headings
        (m, n) radians, by evader; modified in place.
    bounds
        (m,) last captures at the best headings that were met; modified in place.
    flights
        (n, FLIGHT) scratch.
    """
    for row in range(len(sequences)):
        bounds[row] = raise_lower_bound(
            evaders, pursuit, cutoff, _SETTLED, sequences[row], headings[row], flights
        )


@compiled
def raise_lower_bound(
    evaders: Floats,
    pursuit: Pursuit,
    cutoff: float,
    settled: float,
    sequence: Ints,
    headings: Floats,
    flights: Floats,
) -> float:
    """Return the lower bound of one sequence, raised until it reaches the cutoff or is settled.

    Parameters, and what is modified, are as for `raise_lower_bounds`; `settled` is the relative
    gain of a step at which the bound is taken to be the maximum.
    """
    bound = _last_capture(evaders, pursuit, sequence, headings, flights)
    for _ in range(_MOST_STEPS):
        if bound >= cutoff:
            break
        turn_along_gradient(sequence, headings, flights)
        latest = _last_capture(evaders, pursuit, sequence, headings, flights)
        gain = latest - bound
        bound = max(bound, latest)
        if gain <= settled * latest:
            break
    return bound


@compiled
def _last_capture(
    evaders: Floats, pursuit: Pursuit, sequence: Ints, headings: Floats, flights: Floats
) -> float:
    """Return the last capture if all fly straight, the last evader away from the one before.

    The pursuer's `flights` are modified in place.
    """
    last, speed = len(sequence) - 1, pursuit.speed
    disk = GrowingDisk(pursuit.center_x, pursuit.center_y, 0.0, 0.0, speed)
    velocity_x = velocity_y = 0.0
    for k in range(last):
        i = sequence[k]
        x, y, evader_speed = evaders[i, X], evaders[i, Y], evaders[i, SPEED]
        behind_x, behind_y = velocity_x, velocity_y
        velocity_x = evader_speed * math.cos(headings[i])
        velocity_y = evader_speed * math.sin(headings[i])
        closing = (speed - evader_speed) * (speed + evader_speed)
        time = capture_on_line(x, y, velocity_x, velocity_y, closing, disk)
        x, y = x + velocity_x * time, y + velocity_y * time
        _set_direction(flights[k], x - disk.x, y - disk.y)
        flights[k, AHEAD] = speed - _along(flights[k], velocity_x, velocity_y)
        flights[k, BEHIND] = speed - _along(flights[k], behind_x, behind_y)
        disk = GrowingDisk(x, y, 0.0, time, speed)
    i = sequence[last]
    gap = _set_direction(flights[last], evaders[i, X] - disk.x, evaders[i, Y] - disk.y)
    flights[last, AHEAD] = speed - evaders[i, SPEED]
    flights[last, BEHIND] = speed - _along(flights[last], velocity_x, velocity_y)
    fled = (speed * disk.time + gap - pursuit.first_radius) / flights[last, AHEAD]
    return max(fled, disk.time)


@compiled
def _set_direction(flight: Floats, x: float, y: float) -> float:
    """Write the direction of a flight by (x, y), and return its length."""
    length = math.hypot(x, y)
    scale = 1.0 / length if length > 0.0 else 0.0
    flight[TOWARDS_X], flight[TOWARDS_Y] = scale * x, scale * y
    return length


@compiled
def _along(flight: Floats, x: float, y: float) -> float:
    """Return the component of a velocity along a flight."""
    return flight[TOWARDS_X] * x + flight[TOWARDS_Y] * y


@compiled
def turn_along_gradient(sequence: Ints, headings: Floats, flights: Floats) -> None:
    """Turn each evader to where the gradient of the last capture by its velocity points.

    The k-th evader turns to λ_k n_k - λ_{k+1} n_{k+1}, see `plan_for_sequence`. Only the last
    evader's heading is not used. The gradients by position are written to the `flights`.
    """
    costate, next_x, next_y = 1.0, 0.0, 0.0
    for k in range(len(sequence) - 1, -1, -1):
        rate = costate / flights[k, AHEAD]
        own_x, own_y = rate * flights[k, TOWARDS_X], rate * flights[k, TOWARDS_Y]
        gradient_x, gradient_y = own_x - next_x, own_y - next_y
        flights[k, GRADIENT_X], flights[k, GRADIENT_Y] = gradient_x, gradient_y
        if gradient_x != 0.0 or gradient_y != 0.0:
            headings[sequence[k]] = math.atan2(gradient_y, gradient_x)
        costate, next_x, next_y = rate * flights[k, BEHIND], own_x, own_y
