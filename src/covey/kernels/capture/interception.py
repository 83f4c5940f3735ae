"""`mincap` of Algorithm 1: the earliest capture of one evader by a pursuer from a disk (eq. 7)."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Table
from covey.kernels.capture.path import (
    CHORD,
    CLOSING,
    HALF_RATE,
    LINE_X,
    LINE_Y,
    START_COSINE,
    START_SINE,
    START_X,
    START_Y,
    TURN_END,
    VELOCITY_X,
    VELOCITY_Y,
)
from covey.kernels.capture.straight_legs import capture_on_line

_ROUNDING = 1e-17
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
    time = capture_on_line(
        paths[i, LINE_X],
        paths[i, LINE_Y],
        paths[i, VELOCITY_X],
        paths[i, VELOCITY_Y],
        paths[i, CLOSING],
        x,
        y,
        radius,
        start,
        pursuer_speed,
    )
    if time >= paths[i, TURN_END]:
        return time
    return capture_in_turn(paths, i, x, y, radius, start, pursuer_speed)


@compiled
def capture_in_turn(
    paths: Table, i: int, x: float, y: float, radius: float, start: float, pursuer_speed: float
) -> float:
    """The root of eq. (7) while the evader turns: Halley's method, kept in a shrinking bracket.

    The slope of g lies between -(v_p + v) and -(v_p - v), so a step is always defined; one that
    leaves the bracket is replaced by its middle, and should steps be many, every second one. Seen
    along and across the heading at the start of the turn, an arc needs one sine and one cosine.
    """
    off_x, off_y = paths[i, START_X] - x, paths[i, START_Y] - y
    along = off_x * paths[i, START_COSINE] + off_y * paths[i, START_SINE]
    across = off_y * paths[i, START_COSINE] - off_x * paths[i, START_SINE]
    half_rate, diameter = paths[i, HALF_RATE], paths[i, CHORD]
    if half_rate < 0.0:
        across, half_rate = -across, -half_rate
    speed = diameter * half_rate
    low, high, time = start, paths[i, TURN_END], start
    for step in range(_MOST_STEPS):
        sine, cosine = math.sin(half_rate * time), math.cos(half_rate * time)
        ahead = along + diameter * sine * cosine
        aside = across + diameter * sine * sine
        distance = math.sqrt(ahead * ahead + aside * aside)
        gap = distance - radius - pursuer_speed * (time - start)
        if gap > 0.0:
            low = time
        elif gap < 0.0 and time > start:
            high = time
        else:
            break
        turned_cosine, turned_sine = cosine * cosine - sine * sine, 2.0 * sine * cosine
        nearness = 1.0 / distance if distance > 0.0 else 0.0
        away = speed * (ahead * turned_cosine + aside * turned_sine) * nearness
        inward = 2.0 * half_rate * (aside * turned_cosine - ahead * turned_sine)
        bend = (speed * (speed + inward) - away * away) * nearness
        slope = pursuer_speed - away
        # Where the bend would more than double the step, Newton's step is the safer one.
        correction = max(slope * slope - 0.5 * gap * bend, 0.5 * slope * slope)
        move = gap * slope / correction
        closer = time + move
        # The error after a step is of third order in it, over the square of the shortest scale.
        sharpness = move * (2.0 * half_rate + pursuer_speed * nearness)
        if abs(move) * min(sharpness * sharpness, 1.0) <= _ROUNDING * time:
            time = min(max(closer, low), high)
            break
        if not low < closer < high or (step > _MANY_STEPS and step % 2):
            closer = 0.5 * (low + high)
            if closer in (low, high):
                break
        time = closer
    return time
