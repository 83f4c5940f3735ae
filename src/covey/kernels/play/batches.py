"""Many games in parallel, each a step further at a call, one side of them played compiled.

A batch is a state, and what belongs to it, with one more axis in front for each of B games.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints, Workspace
from covey.kernels.maximum.working_set import WorkingSet, without
from covey.kernels.play.commitment import Commitment, commit
from covey.kernels.play.observation import observe
from covey.kernels.play.policy import ReplanOptions, TeamMemory, replan_if_due
from covey.kernels.play.rules import NOBODY, Rules, State, announce, fly, pursuit_from, remove


class Commitments(NamedTuple):
    """How the pursuers of a batch keep to their sequences."""

    margin: float
    sequences: Ints  # (B, N)
    chosen: Ints  # (B,) 0 where a pursuer has no sequence yet


@compiled
def game_of(states: State, b: int) -> State:
    """Return the state of game b, not a copy."""
    return State(
        states.alive[b],
        states.ids[b],
        states.evaders[b],
        states.turns[b],
        states.paths[b],
        states.disk[b],
        states.time[b],
        states.capture_pose[b],
        states.pursuer[b],
    )


@compiled
def memory_of(memories: TeamMemory, b: int) -> TeamMemory:
    """Return the memory of the team of game b, not a copy; all have the same objective."""
    sets = memories.working_set
    return TeamMemory(
        WorkingSet(sets.used[b], sets.sequences[b], sets.weights[b], sets.values[b]),
        memories.uniforms[b],
        memories.last[b],
        memories.objective,
    )


@compiled
def fly_pursuers(
    states: State,
    rules: Rules,
    velocities: Floats,
    team: ReplanOptions,
    memories: TeamMemory,
    workspace: Workspace,
) -> None:
    """Fly each pursuer of a batch at its velocity; each team flies its plan, and replans.

    Parameters
    ----------
    states
        Of B games; modified in place.
    rules
        Of all games.
    velocities
        (B, 2) of the pursuers.
    team
        How the teams replan.
    memories
        Of the teams, an axis of B games in front; modified in place.
    workspace
        With room for all evaders of a game; modified in place.
    """
    for b in range(len(velocities)):
        state = game_of(states, b)
        announce(state, rules)
        captured_row = fly(state, rules, NOBODY, velocities[b, 0], velocities[b, 1])
        if captured_row != NOBODY:
            remove(state, captured_row)
        replan_if_due(state, rules, team, memory_of(memories, b), captured_row, workspace)


@compiled
def fly_teams(
    states: State, rules: Rules, turns: Floats, pursuers: Commitments, workspace: Workspace
) -> None:
    """Turn each evader by its turn (B, N), by number; each pursuer keeps to its sequence."""
    for b in range(len(turns)):
        state = game_of(states, b)
        n = state.alive[0]
        for row in range(n):
            state.turns[row] = turns[b, state.ids[row]]
        announce(state, rules)
        sequence = pursuers.sequences[b, :n]
        commitment = Commitment(pursuers.margin, sequence, pursuers.chosen[b] != 0)
        commit(state.paths[:n], pursuit_from(state.pursuer, rules), False, commitment, workspace)
        pursuers.chosen[b] = 1
        captured_row = fly(state, rules, sequence[0], 0.0, 0.0)
        if captured_row != NOBODY:
            without(sequence, captured_row, sequence)
            remove(state, captured_row)
        for row in range(n):
            state.turns[row] = 0.0


@compiled
def observe_games(states: State, together: bool, seen: npt.NDArray[np.float32]) -> None:
    """Write what each pursuer sees or, `together`, what each team sees from its disk's centre."""
    observers = states.disk if together else states.pursuer
    for b in range(len(seen)):
        observe(game_of(states, b), observers[b, 0], observers[b, 1], NOBODY, seen[b])
