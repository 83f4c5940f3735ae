"""When a pursuer that flies a straight line first comes within reach of an evader's path."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Table
from covey.kernels.capture.path import CHORD, HALF_RATE, TURN_END, position, velocity

_TOUCHING = 1e-12
_MOST_STEPS = 1_000_000  # a pursuer that almost touches for long takes many


@compiled
def first_contact(
    paths: Table,
    i: int,
    x: float,
    y: float,
    velocity_x: float,
    velocity_y: float,
    reach: float,
    latest: float,
) -> float:
    """First time in [0, latest] at which evader i is within `reach` > 0; inf if there is none.

    Steps forward along a parabola that the distance never falls below: with a bound a on the
    relative acceleration, d(t + h) >= d + d' h - a h²/2. On the straight part a is 0 and the
    distance is convex: Newton's method, from the left.
    """
    time = 0.0
    for _ in range(_MOST_STEPS):
        place_x, place_y = position(paths, i, time)
        evader_x, evader_y = velocity(paths, i, time)
        off_x, off_y = place_x - x - velocity_x * time, place_y - y - velocity_y * time
        distance = math.hypot(off_x, off_y)
        gap = distance - reach
        if gap <= _TOUCHING * reach:
            return time
        closing = (off_x * (velocity_x - evader_x) + off_y * (velocity_y - evader_y)) / distance
        turning = time < paths[i, TURN_END]
        bend = paths[i, CHORD] * 2.0 * paths[i, HALF_RATE] ** 2 if turning else 0.0
        if bend > 0.0:
            time += 2.0 * gap / (closing + math.sqrt(closing * closing + 2.0 * bend * gap))
            time = min(time, paths[i, TURN_END])
        elif closing > 0.0:
            time += gap / closing
        else:
            return math.inf
        if time > latest:
            return math.inf
    return math.inf
