"""Many games side by side, each a step further at a call, one side of them played compiled.

A batch is a state, and what belongs to it, with one more axis in front for each of B games.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints, Table
from covey.kernels.maximum.multistart import SearchScratch
from covey.kernels.maximum.sqp import AscentScratch
from covey.kernels.maximum.working_set import Columns
from covey.kernels.play.game import drop_from_sequence
from covey.kernels.play.observation import observe
from covey.kernels.play.policy import TeamMemory, TeamPolicy, plan_again
from covey.kernels.play.replanning import commit
from covey.kernels.play.rules import (
    NOBODY,
    Rules,
    State,
    announce,
    chase_from,
    fly,
    remove,
)


@compiled
def game_of(states: State, b: int) -> State:
    """The state of game b, not a copy."""
    return State(
        states.alive[b],
        states.ids[b],
        states.evaders[b],
        states.turns[b],
        states.paths[b],
        states.disk[b],
        states.time[b],
        states.resting[b],
        states.pursuer[b],
    )


@compiled
def memory_of(memories: TeamMemory, b: int) -> TeamMemory:
    """What the team of game b remembers, not a copy; all have the same aim."""
    columns = memories.columns
    return TeamMemory(
        Columns(columns.used[b], columns.sequences[b], columns.weights[b]),
        memories.noise[b],
        memories.last[b],
        memories.aim,
    )


@compiled
def fly_pursuers(
    states: State,
    rules: Rules,
    velocities: Table,
    team: TeamPolicy,
    memories: TeamMemory,
    search: SearchScratch,
) -> None:
    """Fly each pursuer at its velocity (B, 2); each team flies what it announced, and plans again.

    Each team has `memories` of its own.
    """
    for b in range(len(velocities)):
        state = game_of(states, b)
        announce(state, rules)
        taken = fly(state, rules, NOBODY, velocities[b, 0], velocities[b, 1])
        if taken != NOBODY:
            remove(state, taken)
        plan_again(state, rules, team, memory_of(memories, b), taken, search)


@compiled
def fly_teams(
    states: State,
    rules: Rules,
    turns: Table,
    margin: float,
    sequences: Ints,
    followed: Ints,
    times: Floats,
    scratch: AscentScratch,
) -> None:
    """Turn each evader by its turn (B, N), by number; each pursuer keeps to its sequence (B, N).

    `followed` (B,) is 0 where a pursuer has none yet.
    """
    for b in range(len(turns)):
        state, sequence = game_of(states, b), sequences[b]
        alive = state.alive[0]
        for row in range(alive):
            state.turns[row] = turns[b, state.ids[row]]
        announce(state, rules)
        pursuit = chase_from(state, rules)
        commit(
            state.paths, alive, pursuit, False, margin, followed[b] != 0, sequence, times, scratch
        )
        followed[b] = 1
        taken = fly(state, rules, sequence[0], 0.0, 0.0)
        if taken != NOBODY:
            drop_from_sequence(sequence, alive, taken)
            remove(state, taken)
        for row in range(alive):
            state.turns[row] = 0.0


@compiled
def observe_games(states: State, together: bool, seen: npt.NDArray[np.float32]) -> None:
    """Write what each pursuer sees or, `together`, each team from the middle of its disk."""
    places = states.disk if together else states.pursuer
    for b in range(len(seen)):
        observe(game_of(states, b), places[b, 0], places[b, 1], NOBODY, seen[b])
