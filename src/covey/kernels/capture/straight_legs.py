"""Captures on the straight parts of many paths at once, in the processor's vector registers.

Eight captures cost what one costs in a loop that asks for each evader in turn; they are the same to
the last bit. What happens during a turn is left to `interception`.
"""

from __future__ import annotations

import math

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Table
from covey.kernels.capture.path import CLOSING, LINE_X, LINE_Y, TURN_END, VELOCITY_X, VELOCITY_Y

KNOTS = 5

# Rows of the table of lines; a column is an evader. Then x and y of the knots.
_X, _Y, _VELOCITY_X, _VELOCITY_Y, _CLOSING, _TURN_END = range(6)
_LANES = 4  # in a register: the table is filled up to a multiple of it


@compiled
def padded(n: int) -> int:
    """How many columns a table of n evaders has."""
    return (n + _LANES - 1) // _LANES * _LANES


@allocating
def make_lines(n: int) -> Table:
    """Allocate the table of lines of up to n evaders; those that fill it up do no harm."""
    lines = np.zeros((6, padded(n)))
    lines[_CLOSING] = 1.0
    return lines


@compiled
def set_lines(paths: Table, n: int, lines: Table) -> None:
    """Write the lines of n paths."""
    for i in range(n):
        lines[_X, i], lines[_Y, i] = paths[i, LINE_X], paths[i, LINE_Y]
        lines[_VELOCITY_X, i] = paths[i, VELOCITY_X]
        lines[_VELOCITY_Y, i] = paths[i, VELOCITY_Y]
        lines[_CLOSING, i], lines[_TURN_END, i] = paths[i, CLOSING], paths[i, TURN_END]


@inlined
def capture_on_line(
    line_x: float,
    line_y: float,
    velocity_x: float,
    velocity_y: float,
    closing: float,
    x: float,
    y: float,
    radius: float,
    start: float,
    pursuer_speed: float,
) -> float:
    """Time of capture of an evader that has always flown its line; `start` if it is in the disk.

    Positive root of (v_p^2 - v^2) s^2 - 2 b s - outside = 0, without cancellation. Written without
    branches, so that the compiler can take several evaders at a time.
    """
    gap_x = line_x + velocity_x * start - x
    gap_y = line_y + velocity_y * start - y
    outside = gap_x * gap_x + gap_y * gap_y - radius * radius
    b = gap_x * velocity_x + gap_y * velocity_y - pursuer_speed * radius
    root = math.sqrt(b * b + outside * closing)
    above = b + root if b > 0.0 else outside
    below = closing if b > 0.0 else root - b
    return start + above / below if outside > 0.0 else start


@inlined
def captures_on_lines(
    lines: Table,
    n: int,
    x: float,
    y: float,
    radius: float,
    start: float,
    pursuer_speed: float,
    times: Floats,
) -> None:
    """Write `capture_on_line` for each evader; one before the end of a turn is no capture yet."""
    for i in range(padded(n)):
        times[i] = capture_on_line(
            lines[_X, i],
            lines[_Y, i],
            lines[_VELOCITY_X, i],
            lines[_VELOCITY_Y, i],
            lines[_CLOSING, i],
            x,
            y,
            radius,
            start,
            pursuer_speed,
        )


@inlined
def latest_departures(
    lines: Table,
    n: int,
    x: float,
    y: float,
    radius: float,
    arrival: float,
    pursuer_speed: float,
    slack: float,
    departures: Floats,
) -> None:
    """Raise `departures` to the latest times from which (x, y) is in reach at `arrival`.

    Root of |(x, y) - x_j(t)| = v_p (arrival - t) + radius, eq. (7) run backwards; where the evader
    is still turning then, the end of its turn.
    """
    for j in range(padded(n)):
        velocity_x, velocity_y = lines[_VELOCITY_X, j], lines[_VELOCITY_Y, j]
        closing, turn_end = lines[_CLOSING, j], lines[_TURN_END, j]
        gap_x = x - lines[_X, j] - velocity_x * arrival
        gap_y = y - lines[_Y, j] - velocity_y * arrival
        outside = gap_x * gap_x + gap_y * gap_y - radius * radius
        b = gap_x * velocity_x + gap_y * velocity_y - pursuer_speed * radius
        root = math.sqrt(b * b + outside * closing)
        above = b + root if b > 0.0 else outside
        below = closing if b > 0.0 else root - b
        departure = arrival - above / below if outside > 0.0 else arrival
        turning = min(arrival, turn_end)
        departure = departure if departure >= turn_end else turning
        departures[j] = max(departures[j], departure + slack)
