"""The value of the game of two evaders with simple motion: its Isaacs equation on a grid.

The pursuer has speed 1 and sees all. Turned, scaled and shifted, what matters is two-dimensional:
with a and b the distances of the two, the balance χ = atan2(b, a) and the opening γ, the angle at
which the pursuer sees them. The value is hypot(a, b) W(χ, γ), and by its gradients ∇₁ and ∇₂ along
the two evaders' situations

    1 - |∇₁ + ∇₂| + v₁ |∇₁| + v₂ |∇₂| = 0.

Lax-Friedrichs sweeping: C. Y. Kao, S. Osher, J. Qian, J. Comput. Phys. 196 (2004), with one-sided
slopes of second order.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Matrix, Vector

_FIRST_HEADINGS, _HEADINGS, _ROUNDS = 32, 4, 14
_NARROWER = 0.4


class Grid(NamedTuple):
    """Balances and openings of a grid, and the distances between neighbours there.

    The grid is finer where both evaders are at one point.
    """

    balances: Vector
    balance_steps: Vector
    openings: Vector
    opening_steps: Vector


@compiled
def in_known_order(a: float, b: float, opening: float, first: float, second: float) -> float:
    """Value if the evader at distance `a` is to be captured first, and both know it.

    The other one flees straight from that capture, so one heading is all there is to choose: the
    best of a grid, then of finer ones around it. `first` and `second` are the speeds.
    """
    x, y = b * math.cos(opening), b * math.sin(opening)
    best, heading, width, count = -math.inf, 0.0, math.pi, _FIRST_HEADINGS
    for _ in range(_ROUNDS):
        center = heading
        for k in range(-count, count + 1):
            angle = center + width * k / count
            along = first * math.cos(angle)
            time = a / (math.sqrt(1.0 - first * first + along * along) - along)
            flown = first * time
            gap = math.hypot(x - a - flown * math.cos(angle), y - flown * math.sin(angle))
            if time + gap > best:
                best, heading = time + gap, angle
        width *= 2.0 / count if count == _FIRST_HEADINGS else _NARROWER
        count = _HEADINGS
    return best / (1.0 - second)


@compiled
def upper_bound_at(a: float, b: float, opening: float, v1: float, v2: float) -> float:
    """Value if the pursuer announces the better order: no team can be sure of more."""
    if a == 0.0 or b == 0.0:
        return b / (1.0 - v2) if a == 0.0 else a / (1.0 - v1)
    return min(in_known_order(a, b, opening, v1, v2), in_known_order(b, a, opening, v2, v1))


@entry
def set_upper_bound(grid: Grid, v1: float, v2: float, upper_bound: Matrix) -> None:
    """Write the value of announcing the better order, (balances, openings)."""
    balances, openings = grid.balances, grid.openings
    last = len(balances) - 1
    for i in range(last + 1):
        a = math.cos(balances[i]) if i < last else 0.0
        b = math.sin(balances[i])
        for j in range(len(openings)):
            upper_bound[i, j] = upper_bound_at(a, b, openings[j], v1, v2)


@entry
def set_upper_bounds(situations: Matrix, v1: float, v2: float, upper_bounds: Vector) -> None:
    """Write the value of announcing the better order for rows (a, b, opening)."""
    for k in range(len(situations)):
        a, b, opening = situations[k, 0], situations[k, 1], situations[k, 2]
        upper_bounds[k] = upper_bound_at(a, b, opening, v1, v2)


@inlined
def _isaacs(
    value: float,
    by_balance: float,
    by_opening: float,
    balance: float,
    opening: float,
    v1: float,
    v2: float,
) -> float:
    """The left side of Isaacs' equation."""
    a, b = math.cos(balance), math.sin(balance)
    away1, away2 = value * a - by_balance * b, value * b + by_balance * a
    around1, around2 = by_opening / a, by_opening / b
    cosine, sine = math.cos(opening), math.sin(opening)
    together_x = away1 + away2 * cosine - around2 * sine
    together_y = away2 * sine + around2 * cosine - around1
    return (
        1.0
        - math.hypot(together_x, together_y)
        + v1 * math.hypot(away1, around1)
        + v2 * math.hypot(away2, around2)
    )


@inlined
def _smaller(p: float, q: float) -> float:
    """The smaller of two slopes of one sign, else 0: no new extremum where slopes jump."""
    if p * q <= 0.0:
        return 0.0
    return p if abs(p) < abs(q) else q


@inlined
def _slopes(
    before2: float, before: float, here: float, after: float, after2: float
) -> tuple[float, float]:
    """Slopes a step to the left and to the right, of second order."""
    left, right = here - before, after - here
    curvature = right - left
    left += 0.5 * _smaller(curvature, left - before + before2)
    right -= 0.5 * _smaller(curvature, after2 - after - right)
    return left, right


@inlined
def _reflected(j: int, last: int) -> int:
    """An opening beyond 0 or π is the mirror image of one within."""
    if j < 0:
        return -j
    return 2 * last - j if j > last else j


@entry
def sweep(values: Matrix, upper_bound: Matrix, grid: Grid, v1: float, v2: float) -> float:
    """Sweep the values (balances, openings) in four directions; return the largest change."""
    balances, balance_steps = grid.balances, grid.balance_steps
    openings, opening_steps = grid.openings, grid.opening_steps
    most, last = len(balances) - 1, len(openings) - 1
    largest = 0.0
    for direction in range(4):
        for row in range(1, most):
            i = row if direction < 2 else most - row
            a, b = math.cos(balances[i]), math.sin(balances[i])
            across = ((1.0 + v1) * b + (1.0 + v2) * a) / balance_steps[i]
            for column in range(last + 1):
                j = column if direction % 2 == 0 else last - column
                along = ((1.0 + v1) / a + (1.0 + v2) / b) / opening_steps[j]
                here = values[i, j]
                left, right = _slopes(
                    values[max(i - 2, 0), j],
                    values[i - 1, j],
                    here,
                    values[i + 1, j],
                    values[min(i + 2, most), j],
                )
                down, up = _slopes(
                    values[i, _reflected(j - 2, last)],
                    values[i, _reflected(j - 1, last)],
                    here,
                    values[i, _reflected(j + 1, last)],
                    values[i, _reflected(j + 2, last)],
                )
                rate = _isaacs(
                    here,
                    0.5 * (left + right) / balance_steps[i],
                    0.5 * (down + up) / opening_steps[j],
                    balances[i],
                    openings[j],
                    v1,
                    v2,
                )
                rate += 0.5 * across * (right - left) + 0.5 * along * (up - down)
                new = min(here + rate / (across + along + 2.0), upper_bound[i, j])
                largest = max(largest, abs(new - here))
                values[i, j] = new
    return largest
