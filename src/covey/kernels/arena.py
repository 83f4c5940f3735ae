"""Games with a pursuer that is really somewhere, also where the team knows only a disk.

The pursuer of `State.disk` is a point, which the rules move as a visible one. What the team knows
stands beside it: `known`, centre and radius of the disk in which the pursuer must be.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import compiled
from covey.kernels.path import EVADER, HEADING, SPEED, X, Y
from covey.kernels.rules import NOBODY, Rules, State, fly
from covey.kernels.types import Floats, Pursuit

ROW = EVADER + 1
"""Numbers an evader is described by: x, y, velocity x, y, turn announced, 1 while it lives."""

DISK = 3
"""Numbers behind the last evader: the disk that the team knows of, x, y, radius."""


@compiled
def advance(
    state: State,
    known: Floats,
    rules: Rules,
    hidden: bool,
    target: int,
    velocity_x: float,
    velocity_y: float,
) -> int:
    """Fly as `fly` does, return the row of whom it took, and let the team know what it can.

    The disk grows at the pursuer's speed; at a capture the pursuer is within ρ of the place.
    """
    before = state.time[0]
    taken = fly(state, rules, target, velocity_x, velocity_y)
    if not hidden:
        known[0], known[1], known[2] = state.disk[0], state.disk[1], 0.0
    elif taken == NOBODY:
        known[2] += rules.pursuer_speed * (state.time[0] - before)
    else:
        known[0], known[1] = state.evaders[taken, X], state.evaders[taken, Y]
        known[2] = rules.reach
    return taken


@compiled
def pursuit_as_known(known: Floats, rules: Rules) -> Pursuit:
    """What the team plans against: the first capture from r + ρ, later ones from 2ρ."""
    return Pursuit(
        known[0], known[1], known[2] + rules.reach, 2.0 * rules.reach, rules.pursuer_speed
    )


@compiled
def observe(
    state: State, known: Floats, x: float, y: float, first: int, seen: npt.NDArray[np.float32]
) -> None:
    """Write what is seen from (x, y): a row for each evader, then the disk that the team knows of.

    Evader number `first` comes first, the others by number; a captured one is a row of zeros.
    """
    n = len(state.ids)
    for k in range(len(seen)):
        seen[k] = 0.0
    for row in range(state.alive[0]):
        i = state.ids[row]
        place = i + 1 if i < first else i
        at = ROW * (0 if i == first else place)
        heading, speed = state.evaders[row, HEADING], state.evaders[row, SPEED]
        seen[at], seen[at + 1] = state.evaders[row, X] - x, state.evaders[row, Y] - y
        seen[at + 2], seen[at + 3] = speed * math.cos(heading), speed * math.sin(heading)
        seen[at + 4] = state.turns[row]
        seen[at + 5] = 1.0
    seen[ROW * n], seen[ROW * n + 1] = known[0] - x, known[1] - y
    seen[ROW * n + 2] = known[2]
