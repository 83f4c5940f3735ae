"""`mincap` of Algorithm 1: the earliest capture of one evader by a pursuer from a disk (eq. 7)."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.path import (
    CHORD,
    CLOSING,
    HALF_RATE,
    LINE_X,
    LINE_Y,
    START_HEADING,
    TURN_END,
    VELOCITY_X,
    VELOCITY_Y,
    position,
)
from covey.kernels.types import Table

_ROUNDING = 2e-16
_MANY_STEPS = 12
_MOST_STEPS = 300  # of which every second halves the bracket: these exhaust the doubles


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

    The slope of g lies between -(v_p + v) and -(v_p - v), so a Newton step is always defined; one
    that leaves the bracket is replaced by its middle, and should steps be many, every second one.
    Seen from where the evader is at `start`, along and across its heading there, an arc needs one
    sine and one cosine a step.
    """
    place_x, place_y = position(paths, i, start)
    heading = paths[i, START_HEADING] + 2.0 * paths[i, HALF_RATE] * start
    cosine, sine = math.cos(heading), math.sin(heading)
    along = (place_x - x) * cosine + (place_y - y) * sine
    across = (place_y - y) * cosine - (place_x - x) * sine
    half_rate, diameter = paths[i, HALF_RATE], paths[i, CHORD]
    if half_rate < 0.0:
        across, half_rate = -across, -half_rate
    speed = diameter * half_rate
    low, high = 0.0, paths[i, TURN_END] - start
    time, away, distance = 0.0, along * speed, math.hypot(along, across)
    for step in range(_MOST_STEPS):
        gap = distance - radius - pursuer_speed * time
        if gap > 0.0:
            low = time
        elif gap < 0.0 and time > 0.0:
            high = time
        else:
            break
        slope = pursuer_speed - (away / distance if distance > 0.0 else 0.0)
        closer = time + gap / slope
        if abs(closer - time) <= _ROUNDING * (start + time):
            break
        if not low < closer < high or (step > _MANY_STEPS and step % 2):
            closer = 0.5 * (low + high)
            if closer in (low, high):
                break
        time = closer
        half_sine, half_cosine = math.sin(half_rate * time), math.cos(half_rate * time)
        ahead = along + diameter * half_sine * half_cosine
        aside = across + diameter * half_sine * half_sine
        distance = math.sqrt(ahead * ahead + aside * aside)
        turned = half_cosine * half_cosine - half_sine * half_sine
        away = speed * (ahead * turned + aside * 2.0 * half_sine * half_cosine)
    return start + time
