"""Many games in parallel, each a step further at a call, one side of them played compiled.

A batch of B games is a state, and what belongs to it, whose arrays hold those of all games one
after the other along the first axis.
"""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled, entry
from covey.kernels.arrays import Float32Matrix, IntVector, Matrix, Workspace
from covey.kernels.maximum.working_set import WorkingSet, without
from covey.kernels.play.commitment import Commitment, commit
from covey.kernels.play.observation import observe
from covey.kernels.play.policy import ReplanOptions, TeamMemory, replan_if_due
from covey.kernels.play.rules import NOBODY, Rules, State, announce, fly, pursuit_from, remove


class Commitments(NamedTuple):
    """How the pursuers of a batch keep to their sequences."""

    margin: float
    sequences: IntVector  # (B N,)
    chosen: IntVector  # (B,) 0 where a pursuer has no sequence yet


@compiled
def game_of(states: State, b: int) -> State:
    """Return the state of game b, not a copy."""
    n = len(states.ids) // len(states.alive)
    begin, end = b * n, (b + 1) * n
    return State(
        states.alive[b : b + 1],
        states.ids[begin:end],
        states.evaders[begin:end],
        states.turns[begin:end],
        states.paths[begin:end],
        states.disk[3 * b : 3 * b + 3],
        states.time[b : b + 1],
        states.capture_pose[begin:end],
        states.pursuer[3 * b : 3 * b + 3],
    )


@compiled
def memory_of(memories: TeamMemory, b: int) -> TeamMemory:
    """Return the memory of the team of game b, not a copy; all have the same objective."""
    sets, games = memories.working_set, len(memories.working_set.used)
    m, rows = len(sets.weights) // games, len(memories.uniforms) // games
    begin, end = b * m, (b + 1) * m
    return TeamMemory(
        WorkingSet(
            sets.used[b : b + 1],
            sets.sequences[begin:end],
            sets.weights[begin:end],
            sets.values[begin:end],
        ),
        memories.uniforms[b * rows : (b + 1) * rows],
        memories.last[2 * b : 2 * b + 2],
        memories.objective,
    )


@entry
def fly_pursuers(
    states: State,
    rules: Rules,
    velocities: Matrix,
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
        Of the teams; modified in place.
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


@entry
def fly_teams(
    states: State, rules: Rules, turns: Matrix, pursuers: Commitments, workspace: Workspace
) -> None:
    """Turn each evader by its turn (B, N), by number; each pursuer keeps to its sequence.

    States and commitments of the B games are modified in place.
    """
    for b in range(len(turns)):
        state = game_of(states, b)
        n = state.alive[0]
        for row in range(n):
            state.turns[row] = turns[b, state.ids[row]]
        announce(state, rules)
        sequence = pursuers.sequences[b * turns.shape[1] : b * turns.shape[1] + n]
        commitment = Commitment(pursuers.margin, sequence, pursuers.chosen[b] != 0)
        commit(state.paths[:n], pursuit_from(state.pursuer, rules), False, commitment, workspace)
        pursuers.chosen[b] = 1
        captured_row = fly(state, rules, sequence[0], 0.0, 0.0)
        if captured_row != NOBODY:
            without(sequence, captured_row, sequence)
            remove(state, captured_row)
        for row in range(n):
            state.turns[row] = 0.0


@entry
def observe_games(states: State, together: bool, seen: Float32Matrix) -> None:
    """Write what each pursuer sees or, `together`, what each team sees from its disk's centre.

    `seen` (B, ROW * N + DISK) is modified in place; a row is as `observe` writes it.
    """
    observers = states.disk if together else states.pursuer
    for b in range(len(seen)):
        observe(game_of(states, b), observers[3 * b], observers[3 * b + 1], NOBODY, seen[b])
