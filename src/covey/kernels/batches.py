"""Many games side by side, each a step further at a call, one side of them played compiled.

A batch holds every array of a game with one row, in front, for each of B games.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import compiled
from covey.kernels.arena import advance, observe, pursuit_as_known
from covey.kernels.ascent import AscentScratch
from covey.kernels.columns import Columns, forget_captured
from covey.kernels.game import TeamPolicy, drop_from_sequence
from covey.kernels.replanning import commit, replan
from covey.kernels.rules import NOBODY, Rules, State, announce, pursuit_from, remove
from covey.kernels.search import SearchScratch
from covey.kernels.types import Floats, Ints, Table


class Batch(NamedTuple):
    """B games, and what each team knows."""

    states: State
    known: Table  # (B, 3)


@compiled
def game_of(batch: Batch, b: int) -> State:
    """The state of game b, not a copy."""
    states = batch.states
    return State(
        states.alive[b],
        states.ids[b],
        states.evaders[b],
        states.turns[b],
        states.paths[b],
        states.disk[b],
        states.time[b],
        states.resting[b],
    )


@compiled
def fly_pursuers(
    batch: Batch,
    rules: Rules,
    hidden: bool,
    velocities: Table,
    team: TeamPolicy,
    noise: npt.NDArray[np.float64],
    columns: Columns,
    search: SearchScratch,
) -> None:
    """Fly each pursuer at its velocity (B, 2); each team flies what it announced, and plans again.

    `noise` (B, ., N) and the `columns` are the teams' own.
    """
    for b in range(len(velocities)):
        state, known = game_of(batch, b), batch.known[b]
        own = Columns(columns.used[b], columns.sequences[b], columns.weights[b])
        announce(state, rules)
        taken = advance(state, known, rules, hidden, NOBODY, velocities[b, 0], velocities[b, 1])
        if taken != NOBODY:
            forget_captured(own, state.alive[0], taken)
            remove(state, taken)
        if team.replans and state.alive[0] > 0:
            replan(
                state.evaders,
                state.alive[0],
                pursuit_as_known(known, rules),
                noise[b],
                team.restarts if taken != NOBODY else 0,
                team.tolerance,
                team.most_steps,
                state.turns,
                own,
                search,
            )


@compiled
def fly_teams(
    batch: Batch,
    rules: Rules,
    hidden: bool,
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
        state, known, sequence = game_of(batch, b), batch.known[b], sequences[b]
        alive = state.alive[0]
        for row in range(alive):
            state.turns[row] = turns[b, state.ids[row]]
        announce(state, rules)
        pursuit = pursuit_from(state, rules)
        commit(state.paths, alive, pursuit, margin, followed[b] != 0, sequence, times, scratch)
        followed[b] = 1
        taken = advance(state, known, rules, hidden, sequence[0], 0.0, 0.0)
        if taken != NOBODY:
            drop_from_sequence(sequence, alive, taken)
            remove(state, taken)
        for row in range(alive):
            state.turns[row] = 0.0


@compiled
def observe_games(batch: Batch, together: bool, seen: npt.NDArray[np.float32]) -> None:
    """Write what each pursuer sees or, `together`, each team from the middle of its disk."""
    for b in range(len(seen)):
        x, y = batch.states.disk[b, 0], batch.states.disk[b, 1]
        if together:
            x, y = batch.known[b, 0], batch.known[b, 1]
        observe(game_of(batch, b), batch.known[b], x, y, NOBODY, seen[b])
