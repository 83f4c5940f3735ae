"""Exact first and second derivatives of a sequence's objective by the turns.

With T_k the k-th capture time, P_k its position and n_k the unit vector from P_{k-1} to P_k, the
times solve  |P_k - P_{k-1}| - v_p (T_k - T_{k-1}) - r_k = 0.  The multipliers μ_k of these
equations (one backward pass) give the gradient of T_N, or of the sum of all T_k. With the forward
derivatives of the times they give the Hessian.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import entry, inlined
from covey.kernels.arrays import Floats, Ints, IntVector, Matrix, Vector
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
from covey.kernels.capture.pursuit import Pursuit

# A capture's row: n_k, 1 / |P_k - P_{k-1}|, velocity of the evader, ∂P_k/∂δ, μ_k, ∂L/∂P_k.
NORMAL_X, NORMAL_Y, INVERSE_DISTANCE, SPEED_X, SPEED_Y, DPOSITION_X, DPOSITION_Y = range(7)
MULTIPLIER, COSTATE_X, COSTATE_Y = 7, 8, 9
CAPTURE_ROW = 10


class Captures(NamedTuple):
    """The captures of one sequence of n evaders, and scratch of their second derivatives."""

    times: Vector  # (n,) or more
    rows: Matrix  # (n, CAPTURE_ROW) or more
    slopes: Matrix  # (3, n) or more: derivatives of T_{k-1} and T_k, and of the distance across n_k


@entry
def differentiate(
    paths: Matrix,
    pursuit: Pursuit,
    sequence: IntVector,
    total: bool,
    captures: Captures,
    gradient: Vector,
) -> None:
    """Write the gradient of the last capture, or of the sum, by every evader's turn.

    1. Forward: the geometry of each capture. An evader that is in the disk when it is due is
       captured at that instant: T_k = T_{k-1}, which is the equation above with n_k = 0. While an
       evader turns, its position doesn't depend on the turn's final angle.
    2. Backward: the multipliers, the costates ∂L/∂P_k, and from them the gradient.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    sequence
        (n,) the order of capture.
    total
        Whether the objective is the sum of all capture times.
    captures
        `times` as Algorithm 1 writes them; `rows` modified in place.
    gradient
        (n,) by evader, time per radian; modified in place.
    """
    _set_geometry(paths, pursuit, sequence, captures)
    _set_costates(pursuit, sequence, total, captures.rows, gradient)


@inlined
def _set_geometry(paths: Floats, pursuit: Pursuit, sequence: Ints, captures: Captures) -> None:
    """Write n_k, the inverse distance, the velocity and ∂P_k/∂δ of each capture."""
    rows, times = captures.rows, captures.times
    x, y, before, radius = pursuit.center_x, pursuit.center_y, 0.0, pursuit.first_radius
    for k in range(len(sequence)):
        i, time = sequence[k], times[k]
        capture_x, capture_y = position(paths, i, time)
        off_x, off_y = capture_x - x, capture_y - y
        distance = math.sqrt(off_x * off_x + off_y * off_y)
        rows[k, NORMAL_X] = rows[k, NORMAL_Y] = rows[k, INVERSE_DISTANCE] = 0.0
        if distance > 0.0 and (time > before or distance >= radius):
            rows[k, NORMAL_X], rows[k, NORMAL_Y] = off_x / distance, off_y / distance
            rows[k, INVERSE_DISTANCE] = 1.0 / distance
        rows[k, SPEED_X], rows[k, SPEED_Y] = velocity(paths, i, time)
        rows[k, DPOSITION_X] = rows[k, DPOSITION_Y] = 0.0
        if time > paths[i, TURN_END] and paths[i, STEERS] > 0.0:
            rows[k, DPOSITION_X] = -(time - paths[i, TURN_END]) * paths[i, VELOCITY_Y]
            rows[k, DPOSITION_Y] = (time - paths[i, TURN_END]) * paths[i, VELOCITY_X]
        x, y, before, radius = capture_x, capture_y, time, pursuit.later_radius


@inlined
def _set_costates(
    pursuit: Pursuit, sequence: Ints, total: bool, rows: Floats, gradient: Floats
) -> None:
    """Write multiplier, costate and gradient of each capture, from the last to the first."""
    n, multiplier, next_x, next_y = len(sequence), 0.0, 0.0, 0.0
    for k in range(n - 1, -1, -1):
        onward = 1.0 if total or k == n - 1 else 0.0
        if k < n - 1:
            onward += multiplier * _closing_speed(pursuit, next_x, next_y, rows, k)
        costate_x, costate_y = -multiplier * next_x, -multiplier * next_y
        next_x, next_y = rows[k, NORMAL_X], rows[k, NORMAL_Y]
        multiplier = onward / _closing_speed(pursuit, next_x, next_y, rows, k)
        rows[k, MULTIPLIER] = multiplier
        costate_x, costate_y = costate_x + multiplier * next_x, costate_y + multiplier * next_y
        rows[k, COSTATE_X], rows[k, COSTATE_Y] = costate_x, costate_y
        gradient[sequence[k]] = costate_x * rows[k, DPOSITION_X] + costate_y * rows[k, DPOSITION_Y]


@inlined
def _closing_speed(
    pursuit: Pursuit, normal_x: float, normal_y: float, rows: Floats, k: int
) -> float:
    """Return v_p less the speed along a normal of the k-th captured evader."""
    return pursuit.speed - normal_x * rows[k, SPEED_X] - normal_y * rows[k, SPEED_Y]


@entry
def add_curvature(
    paths: Matrix,
    pursuit: Pursuit,
    sequence: IntVector,
    captures: Captures,
    weight: float,
    hessian: Matrix,
) -> None:
    """Add `weight` times the Hessian of the objective to the lower triangle of `hessian`.

    The Hessian is Z' (∇² of Σ μ_k * equation k) Z, with Z the derivatives of times and turns by the
    turns. For each capture, in order:

    1. `now`: the derivatives of T_k, by the chain rule from those of T_{k-1}.
    2. The distance |P_k - P_{k-1}| curves with the square of what moves across n_k.
    3. The evader's own path curves: in time on the arc; in time and turn on the straight part.

    Parameters
    ----------
    paths, pursuit, sequence
        As for `differentiate`, (n, PATH) and (n,).
    captures
        As `differentiate` left them; `slopes` modified in place.
    weight
        Of this sequence.
    hessian
        (n, n) or more, time per radian squared; its lower triangle is modified in place.
    """
    n, rows, slopes = len(sequence), captures.rows, captures.slopes
    now, earlier, across = slopes[0], slopes[1], slopes[2]
    for i in range(n):
        earlier[i] = 0.0
        now[i] = 0.0
    speed_x = speed_y = dposition_x = dposition_y = 0.0
    previous = -1
    for k in range(n):
        i = sequence[k]
        normal_x, normal_y = rows[k, NORMAL_X], rows[k, NORMAL_Y]
        inverse = 1.0 / _closing_speed(pursuit, normal_x, normal_y, rows, k)
        chain_factor = (pursuit.speed - normal_x * speed_x - normal_y * speed_y) * inverse
        for j in range(n):
            now[j] = chain_factor * earlier[j]
        if previous >= 0:
            now[previous] -= (normal_x * dposition_x + normal_y * dposition_y) * inverse
        now[i] += (normal_x * rows[k, DPOSITION_X] + normal_y * rows[k, DPOSITION_Y]) * inverse

        along_now = normal_x * rows[k, SPEED_Y] - normal_y * rows[k, SPEED_X]
        along_earlier = normal_x * speed_y - normal_y * speed_x
        for j in range(n):
            across[j] = along_now * now[j] - along_earlier * earlier[j]
        across[i] += normal_x * rows[k, DPOSITION_Y] - normal_y * rows[k, DPOSITION_X]
        if previous >= 0:
            across[previous] -= normal_x * dposition_y - normal_y * dposition_x
        normal_curvature = weight * rows[k, MULTIPLIER] * rows[k, INVERSE_DISTANCE]
        time_time, time_turn, turn_turn = _path_curvature(
            paths, i, rows[k], captures.times[k], weight
        )
        for a in range(n):
            curved, timed = normal_curvature * across[a], time_time * now[a]
            for b in range(a + 1):
                hessian[a, b] += curved * across[b] + timed * now[b]
        for j in range(n):
            if j <= i:
                hessian[i, j] += time_turn * now[j]
            if j >= i:
                hessian[j, i] += time_turn * now[j]
        hessian[i, i] += turn_turn

        speed_x, speed_y = rows[k, SPEED_X], rows[k, SPEED_Y]
        dposition_x, dposition_y = rows[k, DPOSITION_X], rows[k, DPOSITION_Y]
        previous = i
        now, earlier = earlier, now


@inlined
def _path_curvature(
    paths: Floats, i: int, row: Floats, time: float, weight: float
) -> tuple[float, float, float]:
    """Return the second derivatives of evader i's path along its costate at its capture.

    By time twice (on the arc), by time and turn, by turn twice (on the straight part); times
    `weight`.
    """
    costate_x, costate_y = weight * row[COSTATE_X], weight * row[COSTATE_Y]
    time_time = time_turn = turn_turn = 0.0
    if time < paths[i, TURN_END]:
        sideways = costate_y * row[SPEED_X] - costate_x * row[SPEED_Y]
        time_time = 2.0 * paths[i, HALF_RATE] * sideways
    elif paths[i, STEERS] > 0.0:
        flown = time - paths[i, TURN_END]
        time_turn = costate_y * paths[i, VELOCITY_X] - costate_x * paths[i, VELOCITY_Y]
        turn_turn = -flown * (costate_x * paths[i, VELOCITY_X] + costate_y * paths[i, VELOCITY_Y])
        turn_turn -= paths[i, TURN_END_SLOPE] * time_turn
    return time_time, time_turn, turn_turn
