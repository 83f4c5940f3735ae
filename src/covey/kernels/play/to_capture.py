"""A hidden pursuer's game from one capture to the next: an edge of the tree of sequences."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, entry
from covey.kernels.arrays import GO_ON, Workspace
from covey.kernels.capture.path import X, Y
from covey.kernels.maximum.objective import elapsed_value
from covey.kernels.minimum.inner_minimum import inner_minimum, inner_scratch, proven_minimum
from covey.kernels.play.policy import ReplanOptions, TeamMemory, replan_if_due
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
"""Of a delay, relative: a delay is a sum of times between updates."""


@entry
def play_to_capture(
    state: State,
    rules: Rules,
    team: ReplanOptions,
    memory: TeamMemory,
    target: int,
    delay: float,
    workspace: Workspace,
) -> bool:
    """Play on until the evader in row `target` is captured, and let the team replan.

    Parameters
    ----------
    state
        Of the game; modified in place.
    rules
        Of the game.
    team, memory
        How the team replans, and its memory, which is modified in place.
    target
        Row of a living evader.
    delay
        The capture waits for the first update that comes at least this time after the first update
        at which the disk contains the evader; 0: the capture comes as soon as it can.
    workspace
        With room for all evaders; modified in place.

    Returns
    -------
    bool
        False if that takes too many updates, or if `workspace.stop` is set.
    """
    contained_since = math.inf
    for _ in range(MOST_UPDATES):
        if workspace.stop[0] != GO_ON:
            break
        if delay > 0.0 and contains(
            state.disk[0],
            state.disk[1],
            state.disk[2] + rules.reach,
            state.evaders[target, X],
            state.evaders[target, Y],
        ):
            contained_since = min(contained_since, state.time[0])
        announce(state, rules)
        due = is_due(state.time[0], contained_since, delay)
        captured_row = fly(state, rules, target if due else NOBODY, 0.0, 0.0)
        if captured_row != NOBODY:
            remove(state, captured_row)
        replan_if_due(state, rules, team, memory, captured_row, workspace)
        if captured_row != NOBODY:
            return True
    return False


@compiled
def contains(center_x: float, center_y: float, radius: float, x: float, y: float) -> bool:
    """Return whether a disk contains a point."""
    off_x, off_y = x - center_x, y - center_y
    return off_x * off_x + off_y * off_y <= radius * radius


@compiled
def is_due(time: float, contained_since: float, delay: float) -> bool:
    """Return whether the pursuer makes for an evader that its disk has contained for the delay."""
    return delay == 0.0 or time - contained_since >= delay * (1.0 - _ROUNDING)


@entry
def guaranteed_value(state: State, rules: Rules, total: bool, workspace: Workspace) -> float:
    """Return the guaranteed last capture, or sum, if the living fly their plan to the end.

    The paths of the state and the workspace are modified in place.
    """
    announce(state, rules)
    n, scratch = state.alive[0], inner_scratch(workspace)
    pursuit = pursuit_from(state.disk, rules)
    found, _ = inner_minimum(
        state.paths[:n], pursuit, total, math.inf, scratch.sequence[:n], scratch
    )
    rest = found if total else proven_minimum(found, n, scratch)
    return rest + elapsed_value(state.time[0], n, total)
