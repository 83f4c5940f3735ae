"""One capture sequence: Algorithm 1, its exact gradient and its exact second derivatives.

With T_k the k-th capture time, P_k its place and n_k the unit vector from P_{k-1} to P_k, the times
solve  |P_k - P_{k-1}| - v_p (T_k - T_{k-1}) - r_k = 0.  The multipliers μ_k of these equations (one
backward pass) give the gradient of T_N, or of the sum of all T_k, and with the forward derivatives
of the times its Hessian.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import (
    HALF_RATE,
    STEERS,
    TURN_END,
    TURN_END_SLOPE,
    VELOCITY_X,
    VELOCITY_Y,
    position,
    velocity,
)


@compiled
def capture_times(paths: Table, pursuit: Pursuit, sequence: Ints, times: Floats) -> float:
    """Algorithm 1: write the capture times in the order of `sequence`; return the last one."""
    x, y, radius, time = pursuit.center_x, pursuit.center_y, pursuit.first_radius, 0.0
    for k in range(len(sequence)):
        time = earliest_capture(paths, sequence[k], x, y, radius, time, pursuit.speed)
        x, y = position(paths, sequence[k], time)
        radius = pursuit.later_radius
        times[k] = time
    return time


@inlined
def measured(times: Floats, n: int, total: bool) -> float:
    """What counts of n capture times, which don't decrease: the last one, or their sum."""
    if not total:
        return times[n - 1]
    value = 0.0
    for k in range(n):
        value += times[k]
    return value


# What a capture contributes to the derivatives: a row of these numbers for each k.
NORMAL_X, NORMAL_Y, CLOSENESS, SPEED_X, SPEED_Y, SWING_X, SWING_Y, MULTIPLIER, PULL_X, PULL_Y = (
    range(10)
)
CAPTURE = 10


@compiled
def differentiate(
    paths: Table,
    pursuit: Pursuit,
    sequence: Ints,
    total: bool,
    times: Floats,
    captures: Floats,
    gradient: Floats,
) -> None:
    """Write the gradient by every evader's turn of what is `measured` (eq. 6's objective).

    `captures` receives what `add_curvature` needs. An evader that is in the disk when its turn to
    be captured comes is captured at that instant: T_k = T_{k-1}, which is the equation above with
    n_k = 0. While an evader turns, its place doesn't depend on the turn's final angle.
    """
    last = len(sequence) - 1
    x, y, before = pursuit.center_x, pursuit.center_y, 0.0
    radius = pursuit.first_radius
    for k in range(last + 1):
        i, time = sequence[k], times[k]
        place_x, place_y = position(paths, i, time)
        off_x, off_y = place_x - x, place_y - y
        distance = math.sqrt(off_x * off_x + off_y * off_y)
        captures[k, NORMAL_X] = captures[k, NORMAL_Y] = captures[k, CLOSENESS] = 0.0
        if distance > 0.0 and (time > before or distance >= radius):
            captures[k, NORMAL_X], captures[k, NORMAL_Y] = (
                off_x / distance,
                off_y / distance,
            )
            captures[k, CLOSENESS] = 1.0 / distance
        captures[k, SPEED_X], captures[k, SPEED_Y] = velocity(paths, i, time)
        captures[k, SWING_X] = captures[k, SWING_Y] = 0.0
        if time > paths[i, TURN_END] and paths[i, STEERS] > 0.0:
            captures[k, SWING_X] = -(time - paths[i, TURN_END]) * paths[i, VELOCITY_Y]
            captures[k, SWING_Y] = (time - paths[i, TURN_END]) * paths[i, VELOCITY_X]
        x, y, before, radius = place_x, place_y, time, pursuit.later_radius

    multiplier, next_x, next_y = 0.0, 0.0, 0.0
    for k in range(last, -1, -1):
        onward = 1.0 if total or k == last else 0.0
        if k < last:
            onward += multiplier * (
                pursuit.speed - next_x * captures[k, SPEED_X] - next_y * captures[k, SPEED_Y]
            )
        pull_x, pull_y = -multiplier * next_x, -multiplier * next_y
        next_x, next_y = captures[k, NORMAL_X], captures[k, NORMAL_Y]
        multiplier = onward / (
            pursuit.speed - next_x * captures[k, SPEED_X] - next_y * captures[k, SPEED_Y]
        )
        captures[k, MULTIPLIER] = multiplier
        captures[k, PULL_X], captures[k, PULL_Y] = (
            pull_x + multiplier * next_x,
            pull_y + multiplier * next_y,
        )
        gradient[sequence[k]] = (
            captures[k, PULL_X] * captures[k, SWING_X] + captures[k, PULL_Y] * captures[k, SWING_Y]
        )


@compiled
def add_curvature(
    paths: Table,
    pursuit: Pursuit,
    sequence: Ints,
    times: Floats,
    captures: Floats,
    weight: float,
    slopes: Floats,
    hessian: Floats,
) -> None:
    """Add `weight` times the Hessian of what is `measured` to the lower triangle of `hessian`.

    It is Z' (∇² of Σ μ_k * equation k) Z, Z the derivatives of times and turns by
    the turns. `slopes` (3, n) is scratch: the derivatives of T_{k-1} and T_k, and of the distance
    across n_k.
    """
    n = len(sequence)
    now, earlier, across = slopes[0], slopes[1], slopes[2]
    for i in range(n):
        earlier[i] = 0.0
        now[i] = 0.0
    speed_x = speed_y = swing_x = swing_y = 0.0
    previous = -1
    for k in range(n):
        i = sequence[k]
        normal_x, normal_y = captures[k, NORMAL_X], captures[k, NORMAL_Y]
        inverse = 1.0 / (
            pursuit.speed - normal_x * captures[k, SPEED_X] - normal_y * captures[k, SPEED_Y]
        )
        carried = (pursuit.speed - normal_x * speed_x - normal_y * speed_y) * inverse
        for j in range(n):
            now[j] = carried * earlier[j]
        if previous >= 0:
            now[previous] -= (normal_x * swing_x + normal_y * swing_y) * inverse
        now[i] += (normal_x * captures[k, SWING_X] + normal_y * captures[k, SWING_Y]) * inverse

        # The distance bends with the square of what moves across it.
        along_now = normal_x * captures[k, SPEED_Y] - normal_y * captures[k, SPEED_X]
        along_earlier = normal_x * speed_y - normal_y * speed_x
        for j in range(n):
            across[j] = along_now * now[j] - along_earlier * earlier[j]
        across[i] += normal_x * captures[k, SWING_Y] - normal_y * captures[k, SWING_X]
        if previous >= 0:
            across[previous] -= normal_x * swing_y - normal_y * swing_x
        bend = weight * captures[k, MULTIPLIER] * captures[k, CLOSENESS]

        # The evader's own path bends: in time on the arc, in time and turn on the line.
        pull_x, pull_y = weight * captures[k, PULL_X], weight * captures[k, PULL_Y]
        time_time = time_turn = turn_turn = 0.0
        if times[k] < paths[i, TURN_END]:
            time_time = (
                2.0
                * paths[i, HALF_RATE]
                * (pull_y * captures[k, SPEED_X] - pull_x * captures[k, SPEED_Y])
            )
        elif paths[i, STEERS] > 0.0:
            flown = times[k] - paths[i, TURN_END]
            time_turn = pull_y * paths[i, VELOCITY_X] - pull_x * paths[i, VELOCITY_Y]
            turn_turn = -flown * (pull_x * paths[i, VELOCITY_X] + pull_y * paths[i, VELOCITY_Y])
            turn_turn -= paths[i, TURN_END_SLOPE] * time_turn
        for a in range(n):
            bent, timed = bend * across[a], time_time * now[a]
            for b in range(a + 1):
                hessian[a, b] += bent * across[b] + timed * now[b]
        for j in range(n):
            if j <= i:
                hessian[i, j] += time_turn * now[j]
            if j >= i:
                hessian[j, i] += time_turn * now[j]
        hessian[i, i] += turn_turn

        speed_x, speed_y = captures[k, SPEED_X], captures[k, SPEED_Y]
        swing_x, swing_y = captures[k, SWING_X], captures[k, SWING_Y]
        previous = i
        now, earlier = earlier, now
