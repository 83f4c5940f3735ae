"""`mincap` of Algorithm 1: the earliest capture of one evader by a pursuer from a disk (eq. 7)."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.path import (
    CLOSING,
    LINE_X,
    LINE_Y,
    TURN_END,
    VELOCITY_X,
    VELOCITY_Y,
    position,
    velocity,
)
from covey.kernels.types import Table

# The bracket halves at every fourth step at the latest, so these exhaust the doubles.
_MOST_STEPS = 300


@inlined
def earliest_capture(
    paths: Table, i: int, x: float, y: float, radius: float, start: float, pursuer_speed: float
) -> float:
    """Earliest time >= `start` at which the disk, growing from `start` on, holds the evader.

    Root of g(t) = |x_e(t) - (x, y)| - v_p (t - start) - radius, which falls strictly, hence has at
    most one; `start` itself where the evader is in the disk already. Closed form when the evader
    is caught on its straight part.
    """
    velocity_x, velocity_y = paths[i, VELOCITY_X], paths[i, VELOCITY_Y]
    gap_x = paths[i, LINE_X] + velocity_x * start - x
    gap_y = paths[i, LINE_Y] + velocity_y * start - y
    outside = gap_x * gap_x + gap_y * gap_y - radius * radius
    if outside > 0.0:
        # (v_p^2 - v^2) s^2 - 2 b s - outside = 0, its positive root without cancellation.
        b = gap_x * velocity_x + gap_y * velocity_y - pursuer_speed * radius
        closing = paths[i, CLOSING]
        root = math.sqrt(b * b + outside * closing)
        time = start + (b + root if b > 0.0 else outside) / (closing if b > 0.0 else root - b)
        if time >= paths[i, TURN_END]:
            return time
    if start >= paths[i, TURN_END]:
        return start
    return _capture_in_turn(paths, i, x, y, radius, start, pursuer_speed)


@compiled
def _capture_in_turn(
    paths: Table, i: int, x: float, y: float, radius: float, start: float, pursuer_speed: float
) -> float:
    """The root of eq. (7) while the evader turns: Newton's method, kept in a shrinking bracket.

    The slope of g lies between -(v_p + v) and -(v_p - v), so a Newton step is always defined. Where
    one leaves the bracket, and at every fourth step whatever happens, the bracket is halved.
    """
    low, high = start, paths[i, TURN_END]
    time = low
    for step in range(_MOST_STEPS):
        place_x, place_y = position(paths, i, time)
        distance = math.hypot(place_x - x, place_y - y)
        gap = distance - radius - pursuer_speed * (time - start)
        if gap > 0.0:
            low = time
        elif gap < 0.0 and time > start:
            high = time
        else:
            break
        velocity_x, velocity_y = velocity(paths, i, time)
        away = 0.0
        if distance > 0.0:
            away = ((place_x - x) * velocity_x + (place_y - y) * velocity_y) / distance
        closer = time + gap / (pursuer_speed - away)
        if closer == time:
            break
        if step % 4 == 3 or not low < closer < high:
            closer = 0.5 * (low + high)
            if closer in (low, high):
                break
        time = closer
    return time
