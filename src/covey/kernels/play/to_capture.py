"""A hidden pursuer's game from one capture to the next: what a tree of sequences is made of."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.capture.path import X, Y
from covey.kernels.maximum.multistart import SearchScratch
from covey.kernels.maximum.objective import spent
from covey.kernels.minimum.inner_minimum import least_value
from covey.kernels.play.policy import TeamMemory, TeamPolicy, plan_again
from covey.kernels.play.rules import (
    MOST_UPDATES,
    NOBODY,
    Rules,
    State,
    announce,
    fly,
    pursuit_from,
    remove,
)

_ROUNDING = 1e-9
"""Of a delay, relative: it is a sum of times between updates."""


@compiled
def play_to_capture(
    state: State,
    rules: Rules,
    team: TeamPolicy,
    memory: TeamMemory,
    target: int,
    delay: float,
    search: SearchScratch,
) -> bool:
    """Play on until the evader in row `target` is captured, and let the team plan anew.

    With a `delay` the capture waits for the first update that comes at least so long after the
    first one at which the disk holds the evader. Returns False if that takes too many updates.
    """
    held_since = math.inf
    for _ in range(MOST_UPDATES):
        if delay > 0.0 and holds(
            state.evaders[target, X],
            state.evaders[target, Y],
            state.disk[0],
            state.disk[1],
            state.disk[2] + rules.reach,
        ):
            held_since = min(held_since, state.time[0])
        announce(state, rules)
        due = is_due(state.time[0], held_since, delay)
        taken = fly(state, rules, target if due else NOBODY, 0.0, 0.0)
        if taken != NOBODY:
            remove(state, taken)
        plan_again(state, rules, team, memory, taken, search)
        if taken != NOBODY:
            return True
    return False


@compiled
def holds(x: float, y: float, center_x: float, center_y: float, radius: float) -> bool:
    """Whether a disk holds a place."""
    off_x, off_y = x - center_x, y - center_y
    return off_x * off_x + off_y * off_y <= radius * radius


@compiled
def is_due(time: float, held_since: float, delay: float) -> bool:
    """Whether the pursuer makes for an evader that its disk has held for so long."""
    return delay == 0.0 or time - held_since >= delay * (1.0 - _ROUNDING)


@compiled
def promise(state: State, rules: Rules, total: bool, search: SearchScratch) -> float:
    """What the living are sure of if they fly what is planned to the end: last capture or sum."""
    announce(state, rules)
    alive = state.alive[0]
    rest, _ = least_value(
        state.paths,
        alive,
        pursuit_from(state, rules),
        total,
        math.inf,
        search.ascent.found,
        search.ascent.worst,
    )
    return rest + spent(state.time[0], alive, total)
