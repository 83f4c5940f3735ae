"""Exact first and second derivatives of the last capture of a branch by its turns.

A position is P_j = p + Σ_k R(heading after segment k - 1) D(turn k, duration k). So what a segment
gains in length and heading moves all of the evader's later path along, and turns it.

The durations τ_k between captures solve  |P_k - P_{k-1}| - v_p τ_k - r_k = 0.  The multipliers μ_k
of these equations (one backward pass) give the gradient of Σ τ_k. With the forward derivatives of
the durations they give the Hessian, as in `capture.derivatives`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, IntVector, Matrix, Vector
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.contingent.branch import (
    END_X,
    END_Y,
    FLOWN,
    RATE,
    SLOPE,
    SPEED_X,
    SPEED_Y,
    Branch,
)

# A capture's row: n_k, 1 / |P_k - P_{k-1}|, μ_k, ∂L/∂P_k.
NORMAL_X, NORMAL_Y, INVERSE_DISTANCE, MULTIPLIER, COSTATE_X, COSTATE_Y = range(6)
CAPTURE = 6

# A control of a segment: ∂P_j by its duration, ∂P_j by its turn, whether the turn turns the rest.
BY_TIME_X, BY_TIME_Y, BY_TURN_X, BY_TURN_Y, TURNS = range(5)
CONTROL = 5


class BranchDerivatives(NamedTuple):
    """Derivatives of a branch by its p turns: evader by evader, segment by segment."""

    captures: Matrix  # (n, CAPTURE)
    controls: Matrix  # (n * n, CONTROL) row j * n + k: segment k of the j-th captured evader
    gradient: Vector  # (p,) time per radian
    variables: IntVector  # (p,) numbers of the turns in the tree
    hessian: Matrix  # (p, p) lower triangle, time per radian squared
    durations: Matrix  # (n, p) derivatives of the durations
    positions: Matrix  # (4, p) derivatives of P_k and P_{k-1}
    rows: Matrix  # (4, p) scratch


def new_branch_derivatives(n: int) -> BranchDerivatives:
    """Allocate the derivatives of branches of up to n captures."""
    p = n * (n + 1) // 2
    return BranchDerivatives(
        np.empty((n, CAPTURE)),
        np.empty((n * n, CONTROL)),
        np.empty(p),
        np.empty(p, np.int64),
        np.empty((p, p)),
        np.empty((n, p)),
        np.empty((4, p)),
        np.empty((4, p)),
    )


@entry
def branch_gradient(
    pursuit: Pursuit, depth: int, n: int, branch: Branch, derivatives: BranchDerivatives
) -> int:
    """Write the gradient of the last capture; return its length p.

    Parameters
    ----------
    pursuit
        The pursuer.
    depth
        Of the tree.
    n
        Number of captures.
    branch
        As `fly_branch` left it.
    derivatives
        `captures`, `controls`, `gradient` and `variables` are modified in place.
    """
    _set_normals(pursuit, n, depth, branch, derivatives.captures)
    _set_controls(n, depth, branch, derivatives.controls)
    _set_costates(pursuit, n, depth, derivatives)
    p = 0
    for j in range(n):
        costate_x = derivatives.captures[j, COSTATE_X]
        costate_y = derivatives.captures[j, COSTATE_Y]
        for k in range(min(j, depth) + 1):
            control = derivatives.controls[j * n + k]
            derivatives.variables[p] = branch.variables[j, k]
            derivatives.gradient[p] = (
                costate_x * control[BY_TURN_X] + costate_y * control[BY_TURN_Y]
            )
            p += 1
    return p


@inlined
def _set_normals(pursuit: Pursuit, n: int, depth: int, branch: Branch, captures: Floats) -> None:
    """Write n_k and the inverse distance of each capture, see `capture.derivatives`."""
    x, y, before, radius = pursuit.center_x, pursuit.center_y, 0.0, pursuit.first_radius
    for k in range(n):
        end, row = branch.segments[k * n + min(k, depth)], captures[k]
        off_x, off_y = end[END_X] - x, end[END_Y] - y
        distance = math.sqrt(off_x * off_x + off_y * off_y)
        row[NORMAL_X] = row[NORMAL_Y] = row[INVERSE_DISTANCE] = 0.0
        if distance > 0.0 and (branch.times[k] > before or distance >= radius):
            row[NORMAL_X], row[NORMAL_Y] = off_x / distance, off_y / distance
            row[INVERSE_DISTANCE] = 1.0 / distance
        x, y, before, radius = end[END_X], end[END_Y], branch.times[k], pursuit.later_radius


@inlined
def _set_controls(n: int, depth: int, branch: Branch, controls: Floats) -> None:
    """Write how each segment's duration and turn move the place of its evader's capture."""
    for j in range(n):
        last = branch.segments[j * n + min(j, depth)]
        for k in range(min(j, depth) + 1):
            end, control = branch.segments[j * n + k], controls[j * n + k]
            rest_x, rest_y = last[END_X] - end[END_X], last[END_Y] - end[END_Y]
            control[BY_TIME_X] = end[SPEED_X] - end[RATE] * rest_y
            control[BY_TIME_Y] = end[SPEED_Y] + end[RATE] * rest_x
            control[BY_TURN_X] = control[BY_TURN_Y] = control[TURNS] = 0.0
            if end[FLOWN] >= 0.0:
                control[BY_TURN_X] = -end[FLOWN] * end[SPEED_Y] - rest_y
                control[BY_TURN_Y] = end[FLOWN] * end[SPEED_X] + rest_x
                control[TURNS] = 1.0


@inlined
def _set_costates(pursuit: Pursuit, n: int, depth: int, derivatives: BranchDerivatives) -> None:
    """Write the multiplier and the costate of each capture, from the last to the first."""
    captures, controls = derivatives.captures, derivatives.controls
    multiplier = next_x = next_y = 0.0
    for k in range(n - 1, -1, -1):
        segment = min(k, depth)
        onward = 1.0
        for j in range(k + 1, n):
            control = controls[j * n + segment]
            onward += captures[j, COSTATE_X] * control[BY_TIME_X]
            onward += captures[j, COSTATE_Y] * control[BY_TIME_Y]
        own = controls[k * n + segment]
        speed_x, speed_y = own[BY_TIME_X], own[BY_TIME_Y]
        onward -= multiplier * (next_x * speed_x + next_y * speed_y)
        costate_x, costate_y = -multiplier * next_x, -multiplier * next_y
        next_x, next_y = captures[k, NORMAL_X], captures[k, NORMAL_Y]
        multiplier = onward / (pursuit.speed - next_x * speed_x - next_y * speed_y)
        captures[k, MULTIPLIER] = multiplier
        captures[k, COSTATE_X] = costate_x + multiplier * next_x
        captures[k, COSTATE_Y] = costate_y + multiplier * next_y


@entry
def branch_hessian(
    pursuit: Pursuit, depth: int, n: int, branch: Branch, derivatives: BranchDerivatives
) -> None:
    """Write the Hessian of the last capture to the lower triangle of `derivatives.hessian`.

    Parameters are those of `branch_gradient`, which must have been called before.

    For each capture, in order: the derivatives of the duration and of the capture's position; the
    curvature of the distance across n_k; the curvature of the evader's own path.
    """
    p, hessian = 0, derivatives.hessian
    for j in range(n):
        p += min(j, depth) + 1
    for a in range(p):
        for b in range(a + 1):
            hessian[a, b] = 0.0
        for row in range(4):
            derivatives.positions[row, a] = 0.0
    first = 0
    for k in range(n):
        now, before = 2 * (k % 2), 2 - 2 * (k % 2)
        _set_slopes(pursuit, depth, n, k, first, p, derivatives)
        capture = derivatives.captures[k]
        normal_x, normal_y = capture[NORMAL_X], capture[NORMAL_Y]
        across, positions = derivatives.rows[0], derivatives.positions
        for a in range(p):
            across[a] = normal_x * (positions[now + 1, a] - positions[before + 1, a])
            across[a] -= normal_y * (positions[now, a] - positions[before, a])
        curvature = capture[MULTIPLIER] * capture[INVERSE_DISTANCE]
        for a in range(p):
            for b in range(a + 1):
                hessian[a, b] += curvature * across[a] * across[b]
        for segment in range(min(k, depth) + 1):
            _add_segment(depth, n, k, segment, first, branch, derivatives)
        first += min(k, depth) + 1


@compiled
def _set_slopes(
    pursuit: Pursuit,
    depth: int,
    n: int,
    k: int,
    first: int,
    p: int,
    derivatives: BranchDerivatives,
) -> None:
    """Write the derivatives of the k-th duration and position; `first`: evader k's first turn."""
    controls, durations, positions = (
        derivatives.controls,
        derivatives.durations,
        derivatives.positions,
    )
    x, y, before = 2 * (k % 2), 2 * (k % 2) + 1, 2 - 2 * (k % 2)
    for a in range(p):
        positions[x, a] = positions[y, a] = 0.0
    for i in range(k):
        control = controls[k * n + min(i, depth)]
        for a in range(p):
            positions[x, a] += control[BY_TIME_X] * durations[i, a]
            positions[y, a] += control[BY_TIME_Y] * durations[i, a]
    for segment in range(min(k, depth) + 1):
        positions[x, first + segment] += controls[k * n + segment, BY_TURN_X]
        positions[y, first + segment] += controls[k * n + segment, BY_TURN_Y]
    capture, control = derivatives.captures[k], controls[k * n + min(k, depth)]
    normal_x, normal_y = capture[NORMAL_X], capture[NORMAL_Y]
    speed_x, speed_y = control[BY_TIME_X], control[BY_TIME_Y]
    inverse = 1.0 / (pursuit.speed - normal_x * speed_x - normal_y * speed_y)
    for a in range(p):
        nearer = normal_x * (positions[x, a] - positions[before, a])
        nearer += normal_y * (positions[y, a] - positions[before + 1, a])
        durations[k, a] = nearer * inverse
        positions[x, a] += speed_x * durations[k, a]
        positions[y, a] += speed_y * durations[k, a]


@compiled
def _add_segment(
    depth: int,
    n: int,
    k: int,
    segment: int,
    first: int,
    branch: Branch,
    derivatives: BranchDerivatives,
) -> None:
    """Add the curvature of a segment of the k-th captured evader's path, along its costate.

    The first turns of the path turn all that follows; the segment curves by itself.
    """
    hessian, durations = derivatives.hessian, derivatives.durations
    turned, duration, moved = derivatives.rows[1], derivatives.rows[2], derivatives.rows[3]
    costate_x = derivatives.captures[k, COSTATE_X]
    costate_y = derivatives.captures[k, COSTATE_Y]
    end, last = branch.segments[k * n + segment], branch.segments[k * n + min(k, depth)]
    control, own = derivatives.controls[k * n + segment], first + segment
    p = first + min(k, depth) + 1  # no later turn moves this evader
    by_time = costate_y * control[BY_TIME_X] - costate_x * control[BY_TIME_Y]
    by_turn = costate_y * control[BY_TURN_X] - costate_x * control[BY_TURN_Y]
    latest = segment if segment < depth else k
    for a in range(p):
        if segment == 0:
            turned[a] = 0.0
        duration[a] = 0.0
        for i in range(segment, latest + 1):
            duration[a] += durations[i, a]
        moved[a] = by_time * duration[a]
    moved[own] += by_turn
    rest = costate_x * (last[END_X] - end[END_X]) + costate_y * (last[END_Y] - end[END_Y])
    sideways = costate_y * end[SPEED_X] - costate_x * end[SPEED_Y]
    onward = costate_x * end[SPEED_X] + costate_y * end[SPEED_Y]
    rate, turns = end[RATE], control[TURNS]
    for a in range(p):
        gain = rate * duration[a] + (turns if a == own else 0.0)
        for b in range(a + 1):
            other = rate * duration[b] + (turns if b == own else 0.0)
            hessian[a, b] += turned[a] * moved[b] + moved[a] * turned[b] - rest * gain * other
            hessian[a, b] += rate * sideways * duration[a] * duration[b]
    if turns > 0.0:
        for a in range(p):
            hessian[max(a, own), min(a, own)] += sideways * duration[a]
        hessian[own, own] += sideways * duration[own]
        hessian[own, own] -= end[FLOWN] * onward + end[SLOPE] * sideways
    for a in range(p):
        turned[a] += rate * duration[a]
    turned[own] += turns
