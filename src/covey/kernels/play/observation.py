"""What learners observe of a game: all positions relative to their own, and the disk."""

from __future__ import annotations

import math

from covey.kernels._jit import entry
from covey.kernels.arrays import Float32Vector
from covey.kernels.capture.path import EVADER, HEADING, SPEED, X, Y
from covey.kernels.play.rules import State

ROW = EVADER + 1
"""Numbers an evader is described by: x, y, velocity x, y, turn announced, 1 while it lives."""

DISK = 3
"""Numbers behind the last evader: the disk that the team knows of, x, y, radius."""


@entry
def observe(state: State, x: float, y: float, first: int, seen: Float32Vector) -> None:
    """Write what is seen from (x, y): a row for each evader, then the disk that the team knows of.

    `seen` (ROW * N + DISK,) is modified in place.

    Evader number `first` comes first, the others by number; a captured one is a row of zeros.
    """
    n = len(state.ids)
    for k in range(len(seen)):
        seen[k] = 0.0
    for row in range(state.alive[0]):
        i = state.ids[row]
        behind = i + 1 if i < first else i
        at = ROW * (0 if i == first else behind)
        heading, speed = state.evaders[row, HEADING], state.evaders[row, SPEED]
        seen[at], seen[at + 1] = state.evaders[row, X] - x, state.evaders[row, Y] - y
        seen[at + 2], seen[at + 3] = speed * math.cos(heading), speed * math.sin(heading)
        seen[at + 4] = state.turns[row]
        seen[at + 5] = 1.0
    seen[ROW * n], seen[ROW * n + 1] = state.disk[0] - x, state.disk[1] - y
    seen[ROW * n + 2] = state.disk[2]
