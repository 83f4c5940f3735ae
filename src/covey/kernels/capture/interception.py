"""`mincap` of Algorithm 1: the earliest capture of one evader by a growing disk (eq. 7)."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, Matrix, Vector
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
from covey.kernels.capture.pursuit import GrowingDisk
from covey.kernels.capture.straight_legs import capture_on_line

_ROUNDING = 1e-17
_MANY_STEPS = 12
_MAX_STEPS = 300  # of which every second halves the bracket: these exhaust the doubles


@inlined
def earliest_capture(paths: Floats, i: int, disk: GrowingDisk) -> float:
    """Return the earliest time >= `disk.time` at which the disk contains evader i.

    Root of g(t) = |x_e(t) - (x, y)| - v_p (t - disk.time) - radius. g falls strictly, hence has at
    most one root; `disk.time` itself where the evader is in the disk already. Closed form where the
    evader is captured on its straight part.
    """
    time = capture_on_line(
        paths[i, LINE_X],
        paths[i, LINE_Y],
        paths[i, VELOCITY_X],
        paths[i, VELOCITY_Y],
        paths[i, CLOSING],
        disk,
    )
    if time >= paths[i, TURN_END]:
        return time
    return capture_in_turn(paths, i, disk)


@entry
def earliest_captures(paths: Matrix, disk: GrowingDisk, times: Vector) -> None:
    """Write the earliest capture of each path (n, PATH) to `times` (n,), all by the same disk."""
    for i in range(len(paths)):
        times[i] = earliest_capture(paths, i, disk)


@compiled
def capture_in_turn(paths: Floats, i: int, disk: GrowingDisk) -> float:
    """Return the root of eq. (7) while the evader turns: Halley's method in a shrinking bracket.

    1. The arc is seen along and across the heading at the start of the turn: so a point of the arc
       needs one sine and one cosine.
    2. The sign of g moves one end of the bracket [disk.time, end of the turn] to the iterate.
    3. A step of Halley's method. The slope of g lies between -(v_p + v) and -(v_p - v), so the step
       is always defined.
    4. A step that leaves the bracket is replaced by the bracket's middle. After many steps every
       second step is.
    5. The iteration ends when the error that a step leaves is below rounding: this error is of
       third order in the step, over the square of the shortest length scale.

    Parameters
    ----------
    paths
        (n, PATH).
    i
        Row of an evader that turns, and is not captured on its straight part.
    disk
        The growing disk.

    Returns
    -------
    float
        The capture time, in [disk.time, end of the turn].
    """
    start, radius, pursuer_speed = disk.time, disk.radius, disk.speed
    off_x, off_y = paths[i, START_X] - disk.x, paths[i, START_Y] - disk.y
    along = off_x * paths[i, START_COSINE] + off_y * paths[i, START_SINE]
    across = off_y * paths[i, START_COSINE] - off_x * paths[i, START_SINE]
    half_rate, diameter = paths[i, HALF_RATE], paths[i, CHORD]
    if half_rate < 0.0:
        across, half_rate = -across, -half_rate
    speed = diameter * half_rate
    low, high, time = start, paths[i, TURN_END], start
    for step in range(_MAX_STEPS):
        sine, cosine = math.sin(half_rate * time), math.cos(half_rate * time)
        along_now = along + diameter * sine * cosine
        across_now = across + diameter * sine * sine
        distance = math.sqrt(along_now * along_now + across_now * across_now)
        gap = distance - radius - pursuer_speed * (time - start)
        if gap > 0.0:
            low = time
        elif gap < 0.0 and time > start:
            high = time
        else:
            break
        turned_cosine, turned_sine = cosine * cosine - sine * sine, 2.0 * sine * cosine
        inverse_distance = 1.0 / distance if distance > 0.0 else 0.0
        away = speed * (along_now * turned_cosine + across_now * turned_sine) * inverse_distance
        inward = 2.0 * half_rate * (across_now * turned_cosine - along_now * turned_sine)
        curvature = (speed * (speed + inward) - away * away) * inverse_distance
        slope = pursuer_speed - away
        # Where the curvature would more than double the step, Newton's step is safer.
        correction = max(slope * slope - 0.5 * gap * curvature, 0.5 * slope * slope)
        move = gap * slope / correction
        closer = time + move
        sharpness = move * (2.0 * half_rate + pursuer_speed * inverse_distance)
        if abs(move) * min(sharpness * sharpness, 1.0) <= _ROUNDING * time:
            time = min(max(closer, low), high)
            break
        if not low < closer < high or (step > _MANY_STEPS and step % 2):
            closer = 0.5 * (low + high)
            if closer in (low, high):
                break
        time = closer
    return time
