"""When a pursuer that flies a straight line first comes within reach of an evader's path."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats
from covey.kernels.capture.path import CHORD, HALF_RATE, TURN_END, position, velocity

_TOUCHING = 1e-12
_MAX_STEPS = 1_000_000  # a pursuer that almost touches for long takes many


class Flight(NamedTuple):
    """The straight flight of a pursuer, and its reach."""

    x: float  # at time 0
    y: float
    velocity_x: float
    velocity_y: float
    reach: float  # > 0


@compiled
def first_contact(paths: Floats, i: int, flight: Flight, latest: float) -> float:
    """Return the first time in [0, latest] at which evader i is within reach; inf if none.

    Steps forward along a parabola that the distance never falls below: with a bound a on the
    relative acceleration, d(t + h) >= d + d' h - a h²/2. On the straight part a is 0 and the
    distance is convex: Newton's method, from the left.
    """
    velocity_x, velocity_y, reach = flight.velocity_x, flight.velocity_y, flight.reach
    time = 0.0
    for _ in range(_MAX_STEPS):
        x, y = position(paths, i, time)
        evader_x, evader_y = velocity(paths, i, time)
        off_x, off_y = x - flight.x - velocity_x * time, y - flight.y - velocity_y * time
        distance = math.hypot(off_x, off_y)
        gap = distance - reach
        if gap <= _TOUCHING * reach:
            return time
        closing = (off_x * (velocity_x - evader_x) + off_y * (velocity_y - evader_y)) / distance
        turning = time < paths[i, TURN_END]
        acceleration = paths[i, CHORD] * 2.0 * paths[i, HALF_RATE] ** 2 if turning else 0.0
        if acceleration > 0.0:
            time += 2.0 * gap / (closing + math.sqrt(closing * closing + 2.0 * acceleration * gap))
            time = min(time, paths[i, TURN_END])
        elif closing > 0.0:
            time += gap / closing
        else:
            return math.inf
        if time > latest:
            return math.inf
    return math.inf
