"""The rules of play, once for all: how the state of a game moves from one decision to the next.

Between decisions everyone flies what was announced, and a capture happens at its exact time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.contact import first_contact
from covey.kernels.interception import earliest_capture
from covey.kernels.path import (
    EVADER,
    HALF_RATE,
    HEADING,
    PATH,
    TURN_END,
    TURN_RATE,
    X,
    Y,
    position,
    set_paths,
)
from covey.kernels.types import Floats, Ints, Pursuit, Table

NOBODY = -1

MOST_UPDATES = 200_000
"""A game is stopped then: it would take for ever, and its record all memory."""


class Rules(NamedTuple):
    """What stays the same during a game."""

    pursuer_speed: float
    reach: float  # ρ
    hidden: bool
    update_time: float
    time_limit: float


class State(NamedTuple):
    """The living, in the first `alive[0]` rows, and the pursuer."""

    alive: Ints  # (1,)
    ids: Ints  # (N,) numbers of the living
    evaders: Table  # (N, EVADER)
    turns: Floats  # (N,) announced, still to be flown
    paths: Table  # (N, PATH) of what is announced, from now on
    disk: Floats  # (3,) centre and radius of where the pursuer can be, for all the team knows
    time: Floats  # (1,)
    resting: Table  # (N, 3) place and heading at the capture, by number


@allocating
def initial_state(evaders: Table, center_x: float, center_y: float, radius: float) -> State:
    """The state at time 0, nothing announced."""
    n = len(evaders)
    return State(
        np.full(1, n),
        np.arange(n),
        evaders.copy(),
        np.zeros(n),
        np.empty((n, PATH)),
        np.array([center_x, center_y, radius]),
        np.zeros(1),
        np.zeros((n, 3)),
    )


@compiled
def pursuit_from(state: State, rules: Rules) -> Pursuit:
    """What the team plans against: the disk, the first capture from r + ρ, later ones from 2ρ."""
    return Pursuit(
        state.disk[0],
        state.disk[1],
        state.disk[2] + rules.reach,
        2.0 * rules.reach,
        rules.pursuer_speed,
    )


@compiled
def announce(state: State, rules: Rules) -> None:
    """Turn the announced turns into paths."""
    n = state.alive[0]
    set_paths(state.evaders[:n], state.turns[:n], rules.pursuer_speed, state.paths)


@compiled
def fly(state: State, rules: Rules, target: int, velocity_x: float, velocity_y: float) -> int:
    """Fly what is announced until the next update or capture; return the row of whom it took.

    The pursuer makes for the living evader in row `target` or, where that is `NOBODY`, flies the
    velocity given. A hidden pursuer is its disk: it takes its target when the disk reaches it, and
    nobody else. A visible one takes whomever it comes within ρ of. The one captured stays in the
    state, for the record, until `remove` is called.
    """
    disk, paths = state.disk, state.paths
    elapsed, captured = min(rules.update_time, rules.time_limit - state.time[0]), NOBODY
    if target != NOBODY:
        meeting = earliest_capture(
            paths, target, disk[0], disk[1], disk[2] + rules.reach, 0.0, rules.pursuer_speed
        )
        if not rules.hidden:
            meeting_x, meeting_y = position(paths, target, meeting)
            velocity_x, velocity_y = _place_and_aim(state, rules, meeting_x, meeting_y)
        if meeting <= elapsed:
            elapsed, captured = meeting, target
    elif not rules.hidden:
        disk[2] = 0.0
    if not rules.hidden and rules.reach > 0.0:
        elapsed, captured = _first_taken(
            state, rules, disk[0], disk[1], velocity_x, velocity_y, target, elapsed, captured
        )
    _move_pursuer(state, rules, elapsed, captured, captured == target, velocity_x, velocity_y)
    _move_evaders(state, elapsed)
    state.time[0] += elapsed
    return captured


@compiled
def fly_hidden_point(
    state: State, rules: Rules, place: Floats, velocity_x: float, velocity_y: float
) -> int:
    """Fly what is announced, with a hidden pursuer that has a place (2,) in its disk.

    It flies the velocity given and takes whomever it comes within ρ > 0 of, as a visible one does;
    of its place the team learns only by captures. Otherwise as `fly`.
    """
    elapsed, captured = _first_taken(
        state,
        rules,
        place[0],
        place[1],
        velocity_x,
        velocity_y,
        NOBODY,
        min(rules.update_time, rules.time_limit - state.time[0]),
        NOBODY,
    )
    place[0] += velocity_x * elapsed
    place[1] += velocity_y * elapsed
    _move_pursuer(state, rules, elapsed, captured, False, velocity_x, velocity_y)
    _move_evaders(state, elapsed)
    state.time[0] += elapsed
    return captured


@compiled
def _first_taken(
    state: State,
    rules: Rules,
    x: float,
    y: float,
    velocity_x: float,
    velocity_y: float,
    target: int,
    elapsed: float,
    captured: int,
) -> tuple[float, int]:
    """When and whom a flight from (x, y) first takes, if not its target `captured` at `elapsed`."""
    for i in range(state.alive[0]):
        if i != target:
            contact = first_contact(
                state.paths, i, x, y, velocity_x, velocity_y, rules.reach, elapsed
            )
            if contact < elapsed or (contact == elapsed and captured == NOBODY):
                elapsed, captured = contact, i
    return elapsed, captured


@compiled
def _place_and_aim(state: State, rules: Rules, goal_x: float, goal_y: float) -> tuple[float, float]:
    """Velocity of a visible pursuer towards its goal.

    Where the game began with a disk, the pursuer turns out to be where in it the goal is nearest;
    one that doesn't make for an evader, at its centre.
    """
    disk = state.disk
    off_x, off_y = goal_x - disk[0], goal_y - disk[1]
    distance = math.hypot(off_x, off_y)
    if distance == 0.0:
        disk[2] = 0.0
        return 0.0, 0.0
    towards_x, towards_y = off_x / distance, off_y / distance
    ahead = min(disk[2], distance)
    disk[0] += ahead * towards_x
    disk[1] += ahead * towards_y
    disk[2] = 0.0
    if ahead == distance:
        return 0.0, 0.0
    return rules.pursuer_speed * towards_x, rules.pursuer_speed * towards_y


@compiled
def _move_pursuer(
    state: State,
    rules: Rules,
    elapsed: float,
    captured: int,
    aimed: bool,
    velocity_x: float,
    velocity_y: float,
) -> None:
    """Move the pursuer or let its disk grow; collapse the disk at a capture."""
    disk = state.disk
    if rules.hidden and captured == NOBODY:
        disk[2] += rules.pursuer_speed * elapsed
    elif rules.hidden:
        disk[0], disk[1] = position(state.paths, captured, elapsed)
        disk[2] = rules.reach
    elif captured != NOBODY and aimed and rules.reach == 0.0:
        disk[0], disk[1] = position(state.paths, captured, elapsed)
    else:
        disk[0] += velocity_x * elapsed
        disk[1] += velocity_y * elapsed


@compiled
def _move_evaders(state: State, elapsed: float) -> None:
    """Move the living along their paths, and take what they turned off their announced turns."""
    for i in range(state.alive[0]):
        turn_end = state.paths[i, TURN_END]
        state.evaders[i, X], state.evaders[i, Y] = position(state.paths, i, elapsed)
        if elapsed >= turn_end:
            if turn_end > 0.0 or math.isinf(state.evaders[i, TURN_RATE]):
                state.evaders[i, HEADING] += state.turns[i]
            state.turns[i] = 0.0
        else:
            turned = 2.0 * state.paths[i, HALF_RATE] * elapsed
            state.evaders[i, HEADING] += turned
            state.turns[i] -= turned


@compiled
def remove(state: State, row: int) -> None:
    """Lay a captured evader to rest, and close the gap it leaves among the living."""
    last, number = state.alive[0] - 1, state.ids[row]
    state.resting[number, 0] = state.evaders[row, X]
    state.resting[number, 1] = state.evaders[row, Y]
    state.resting[number, 2] = state.evaders[row, HEADING]
    for i in range(row, last):
        state.ids[i] = state.ids[i + 1]
        state.turns[i] = state.turns[i + 1]
        for column in range(EVADER):
            state.evaders[i, column] = state.evaders[i + 1, column]
    state.alive[0] = last
