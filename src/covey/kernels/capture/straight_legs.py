"""Captures on the straight parts of many paths at once, in the processor's vector registers.

Eight captures cost what one capture costs in a loop over evaders, with the same bits. Captures
during a turn are left to `interception`.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, padded
from covey.kernels.capture.path import CLOSING, LINE_X, LINE_Y, TURN_END, VELOCITY_X, VELOCITY_Y
from covey.kernels.capture.pursuit import GrowingDisk

# Rows of the table of lines; a column is an evader.
_X, _Y, _VELOCITY_X, _VELOCITY_Y, _CLOSING, _TURN_END = range(6)
LINES = 6


@compiled
def set_lines(paths: Floats, lines: Floats) -> None:
    """Write the lines of all paths; the columns that pad the table stand still."""
    n = len(paths)
    for i in range(padded(n)):
        line = paths[min(i, n - 1)]
        lines[_X, i], lines[_Y, i] = line[LINE_X], line[LINE_Y]
        lines[_VELOCITY_X, i], lines[_VELOCITY_Y, i] = line[VELOCITY_X], line[VELOCITY_Y]
        lines[_CLOSING, i], lines[_TURN_END, i] = line[CLOSING], line[TURN_END]


@inlined
def capture_on_line(
    line_x: float,
    line_y: float,
    velocity_x: float,
    velocity_y: float,
    closing: float,
    disk: GrowingDisk,
) -> float:
    """Return when an evader that has always flown its line is captured.

    Positive root of (v_p^2 - v^2) s^2 - 2 b s - outside = 0, without cancellation; `disk.time`
    where the evader is in the disk. Written without branches, so that the compiler can take several
    evaders at a time.

    Parameters
    ----------
    line_x, line_y
        The line at time 0, lengths.
    velocity_x, velocity_y
        Of the evader.
    closing
        v_p^2 - v^2 > 0.
    disk
        The growing disk.
    """
    start, radius = disk.time, disk.radius
    gap_x = line_x + velocity_x * start - disk.x
    gap_y = line_y + velocity_y * start - disk.y
    outside = gap_x * gap_x + gap_y * gap_y - radius * radius
    b = gap_x * velocity_x + gap_y * velocity_y - disk.speed * radius
    root = math.sqrt(b * b + outside * closing)
    above = b + root if b > 0.0 else outside
    below = closing if b > 0.0 else root - b
    return start + above / below if outside > 0.0 else start


@inlined
def captures_on_lines(lines: Floats, disk: GrowingDisk, times: Floats) -> None:
    """Write `capture_on_line` for each column; a time before the end of a turn is no capture."""
    for i in range(len(times)):
        times[i] = capture_on_line(
            lines[_X, i],
            lines[_Y, i],
            lines[_VELOCITY_X, i],
            lines[_VELOCITY_Y, i],
            lines[_CLOSING, i],
            disk,
        )


@inlined
def latest_departures(lines: Floats, goal: GrowingDisk, slack: float, departures: Floats) -> None:
    """Raise `departures` to the latest times, plus `slack`, from which the goal is in reach.

    The goal is to be reached at `goal.time`. Root of |(x, y) - x_j(t)| = v_p (time - t) + radius,
    eq. (7) run backwards; where the evader is still turning then, the end of its turn.
    """
    arrival, radius = goal.time, goal.radius
    for j in range(len(departures)):
        velocity_x, velocity_y = lines[_VELOCITY_X, j], lines[_VELOCITY_Y, j]
        closing, turn_end = lines[_CLOSING, j], lines[_TURN_END, j]
        gap_x = goal.x - lines[_X, j] - velocity_x * arrival
        gap_y = goal.y - lines[_Y, j] - velocity_y * arrival
        outside = gap_x * gap_x + gap_y * gap_y - radius * radius
        b = gap_x * velocity_x + gap_y * velocity_y - goal.speed * radius
        root = math.sqrt(b * b + outside * closing)
        above = b + root if b > 0.0 else outside
        below = closing if b > 0.0 else root - b
        departure = arrival - above / below if outside > 0.0 else arrival
        turning = min(arrival, turn_end)
        departure = departure if departure >= turn_end else turning
        departures[j] = max(departures[j], departure + slack)
