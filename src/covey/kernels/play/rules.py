"""The rules of play, once for all: how the state of a game moves from one decision to the next.

Between decisions everyone flies what was announced, and a capture happens at its exact time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import (
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
from covey.kernels.play.first_contact import first_contact

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
    placed: bool = False  # the pursuer has a place from the start, also where it is hidden


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
    pursuer: Floats  # (3,) its place and 0; all of the disk where it has no place


@allocating
def initial_state(evaders: Table, center_x: float, center_y: float, radius: float) -> State:
    """The state at time 0, nothing announced."""
    n, disk = len(evaders), np.array([center_x, center_y, radius])
    return State(
        np.full(1, n),
        np.arange(n),
        evaders.copy(),
        np.zeros(n),
        np.empty((n, PATH)),
        disk,
        np.zeros(1),
        np.zeros((n, 3)),
        disk.copy(),
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
def chase_from(state: State, rules: Rules) -> Pursuit:
    """What the pursuer plans with: as the team's, but from its place where it has one."""
    return Pursuit(
        state.pursuer[0],
        state.pursuer[1],
        state.pursuer[2] + rules.reach,
        2.0 * rules.reach,
        rules.pursuer_speed,
    )


@compiled
def flies(rules: Rules) -> bool:
    """Whether the pursuer flies from place to place; one that doesn't is a disk that grows."""
    return rules.placed or not rules.hidden


@compiled
def announce(state: State, rules: Rules) -> None:
    """Turn the announced turns into paths."""
    n = state.alive[0]
    set_paths(state.evaders[:n], state.turns[:n], rules.pursuer_speed, state.paths)


@compiled
def fly(state: State, rules: Rules, target: int, velocity_x: float, velocity_y: float) -> int:
    """Fly what is announced until the next update or capture; return the row of whom it took.

    The pursuer makes for the living evader in row `target` or, where that is `NOBODY`, flies the
    velocity given. A hidden pursuer is its disk, unless it is placed: it takes its target when the
    disk reaches it, and nobody else. One that has a place takes whomever it comes within ρ of. The
    one captured stays in the state, for the record, until `remove` is called.
    """
    pursuer, paths, moves = state.pursuer, state.paths, flies(rules)
    elapsed, captured = min(rules.update_time, rules.time_limit - state.time[0]), NOBODY
    if target != NOBODY:
        meeting = earliest_capture(
            paths,
            target,
            pursuer[0],
            pursuer[1],
            pursuer[2] + rules.reach,
            0.0,
            rules.pursuer_speed,
        )
        if moves:
            meeting_x, meeting_y = position(paths, target, meeting)
            velocity_x, velocity_y = _place_and_aim(state, rules, meeting_x, meeting_y)
        if meeting <= elapsed:
            elapsed, captured = meeting, target
    elif moves:
        pursuer[2] = 0.0
    if moves and rules.reach > 0.0:
        for i in range(state.alive[0]):
            if i != target:
                contact = first_contact(
                    paths, i, pursuer[0], pursuer[1], velocity_x, velocity_y, rules.reach, elapsed
                )
                if contact < elapsed or (contact == elapsed and captured == NOBODY):
                    elapsed, captured = contact, i
    if moves:
        met = captured if rules.reach == 0.0 else NOBODY
        _move_pursuer(state, elapsed, met, velocity_x, velocity_y)
    _move_disk(state, rules, elapsed, captured)
    _move_evaders(state, elapsed)
    state.time[0] += elapsed
    return captured


@compiled
def _place_and_aim(state: State, rules: Rules, goal_x: float, goal_y: float) -> tuple[float, float]:
    """Velocity towards its goal of a pursuer that flies.

    Where the game began with a disk, the pursuer turns out to be where in it the goal is nearest;
    one that doesn't make for an evader, at its centre.
    """
    pursuer = state.pursuer
    off_x, off_y = goal_x - pursuer[0], goal_y - pursuer[1]
    distance = math.hypot(off_x, off_y)
    if distance == 0.0:
        pursuer[2] = 0.0
        return 0.0, 0.0
    towards_x, towards_y = off_x / distance, off_y / distance
    ahead = min(pursuer[2], distance)
    pursuer[0] += ahead * towards_x
    pursuer[1] += ahead * towards_y
    pursuer[2] = 0.0
    if ahead == distance:
        return 0.0, 0.0
    return rules.pursuer_speed * towards_x, rules.pursuer_speed * towards_y


@compiled
def _move_pursuer(
    state: State, elapsed: float, met: int, velocity_x: float, velocity_y: float
) -> None:
    """Move a pursuer that flies; without reach, to where it `met` its target, to the last bit."""
    pursuer = state.pursuer
    if met != NOBODY:
        pursuer[0], pursuer[1] = position(state.paths, met, elapsed)
    else:
        pursuer[0] += velocity_x * elapsed
        pursuer[1] += velocity_y * elapsed


@compiled
def _move_disk(state: State, rules: Rules, elapsed: float, captured: int) -> None:
    """What the team knows: a place, if it sees it, or a disk that a capture makes collapse.

    A pursuer that doesn't fly is that disk.
    """
    disk, pursuer = state.disk, state.pursuer
    if not rules.hidden:
        for k in range(3):
            disk[k] = pursuer[k]
    elif captured == NOBODY:
        disk[2] += rules.pursuer_speed * elapsed
    else:
        disk[0], disk[1] = position(state.paths, captured, elapsed)
        disk[2] = rules.reach
    if not flies(rules):
        for k in range(3):
            pursuer[k] = disk[k]


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
