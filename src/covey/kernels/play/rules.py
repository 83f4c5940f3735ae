"""The rules of play: how the state of a game moves from one decision to the next.

Between decisions everyone flies what was announced, and a capture happens at its exact time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, IntVector, Matrix, Vector
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
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.library.layout import kept
from covey.kernels.play.first_contact import Flight, first_contact

NOBODY = -1

MOST_UPDATES = 200_000
"""A game is stopped after so many: its record would take all memory."""


@kept
class Rules(NamedTuple):
    """What stays the same during a game."""

    pursuer_speed: float
    reach: float  # ρ
    hidden: bool
    update_time: float
    time_limit: float
    has_position: bool = False  # the pursuer is placed at the start, even where it is hidden


@kept
class State(NamedTuple):
    """The living, in the first `alive[0]` rows, and the pursuer."""

    alive: IntVector  # (1,)
    ids: IntVector  # (N,) numbers of the living
    evaders: Matrix  # (N, EVADER)
    turns: Vector  # (N,) announced, still to be flown
    paths: Matrix  # (N, PATH) of what is announced, from now on
    disk: Vector  # (3,) centre and radius of the disk that the team knows the pursuer in
    time: Vector  # (1,)
    capture_pose: Matrix  # (N, 3) position and heading at the capture, by number
    pursuer: Vector  # (3,) its position and 0; the whole disk where it has no position


def initial_state(evaders: Floats, center_x: float, center_y: float, radius: float) -> State:
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


@inlined
def pursuit_from(disk: Floats, rules: Rules) -> Pursuit:
    """Return the pursuit from a disk (3,): first capture from r + ρ, later captures from 2ρ.

    From `state.disk` the team plans, from `state.pursuer` the pursuer.
    """
    first_radius, later_radius = disk[2] + rules.reach, 2.0 * rules.reach
    return Pursuit(disk[0], disk[1], first_radius, later_radius, rules.pursuer_speed)


@compiled
def moves(rules: Rules) -> bool:
    """Whether the pursuer flies from position to position; otherwise it is a growing disk."""
    return rules.has_position or not rules.hidden


@entry
def announce(state: State, rules: Rules) -> None:
    """Write the paths of the announced turns to `state.paths`."""
    n = state.alive[0]
    set_paths(state.evaders[:n], state.turns[:n], rules.pursuer_speed, state.paths)


@entry
def fly(state: State, rules: Rules, target: int, velocity_x: float, velocity_y: float) -> int:
    """Fly what is announced until the next update or capture; return the captured row.

    1. The pursuer makes for its target, or flies the velocity. A hidden pursuer is its disk, unless
       it has a position. It captures its target when the disk reaches the target, and nobody else.
    2. A pursuer with a position and a reach captures whomever it comes within ρ of first.
    3. Pursuer, disk and evaders move to the time of the capture, or of the update.

    Parameters
    ----------
    state
        Modified in place. A captured evader stays in the state until `remove` is called.
    rules
        Of the game.
    target
        Row of the living evader that the pursuer makes for, or `NOBODY`.
    velocity_x, velocity_y
        Of a pursuer without a target.

    Returns
    -------
    int
        The row of the captured evader, or `NOBODY`.
    """
    pursuer, paths, flies = state.pursuer, state.paths, moves(rules)
    elapsed, captured_row = min(rules.update_time, rules.time_limit - state.time[0]), NOBODY
    if target != NOBODY:
        radius = pursuer[2] + rules.reach
        disk = GrowingDisk(pursuer[0], pursuer[1], radius, 0.0, rules.pursuer_speed)
        meeting = earliest_capture(paths, target, disk)
        if flies:
            meeting_x, meeting_y = position(paths, target, meeting)
            velocity_x, velocity_y = _place_and_aim(state, rules, meeting_x, meeting_y)
        if meeting <= elapsed:
            elapsed, captured_row = meeting, target
    elif flies:
        pursuer[2] = 0.0
    if flies and rules.reach > 0.0:
        flight = Flight(pursuer[0], pursuer[1], velocity_x, velocity_y, rules.reach)
        for i in range(state.alive[0]):
            if i != target:
                contact = first_contact(paths, i, flight, elapsed)
                if contact < elapsed or (contact == elapsed and captured_row == NOBODY):
                    elapsed, captured_row = contact, i
    if flies:
        met = captured_row if rules.reach == 0.0 else NOBODY
        _move_pursuer(state, elapsed, met, velocity_x, velocity_y)
    _move_disk(state, rules, elapsed, captured_row)
    _move_evaders(state, elapsed)
    state.time[0] += elapsed
    return captured_row


@compiled
def _place_and_aim(state: State, rules: Rules, goal_x: float, goal_y: float) -> tuple[float, float]:
    """Return the velocity towards its goal of a pursuer that moves.

    A pursuer that is still a disk is placed at the disk's point nearest to the goal.
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
    """Move the pursuer; without reach, to where it `met` its target, to the last bit."""
    pursuer = state.pursuer
    if met != NOBODY:
        pursuer[0], pursuer[1] = position(state.paths, met, elapsed)
    else:
        pursuer[0] += velocity_x * elapsed
        pursuer[1] += velocity_y * elapsed


@compiled
def _move_disk(state: State, rules: Rules, elapsed: float, captured_row: int) -> None:
    """Move the disk that the team knows: to a pursuer that it sees, else grown, or collapsed.

    A pursuer that doesn't move is this disk.
    """
    disk, pursuer = state.disk, state.pursuer
    if not rules.hidden:
        for k in range(3):
            disk[k] = pursuer[k]
    elif captured_row == NOBODY:
        disk[2] += rules.pursuer_speed * elapsed
    else:
        disk[0], disk[1] = position(state.paths, captured_row, elapsed)
        disk[2] = rules.reach
    if not moves(rules):
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
    """Keep the pose of a captured evader, and close the gap that it leaves among the living."""
    last, number = state.alive[0] - 1, state.ids[row]
    state.capture_pose[number, 0] = state.evaders[row, X]
    state.capture_pose[number, 1] = state.evaders[row, Y]
    state.capture_pose[number, 2] = state.evaders[row, HEADING]
    for i in range(row, last):
        state.ids[i] = state.ids[i + 1]
        state.turns[i] = state.turns[i + 1]
        for column in range(EVADER):
            state.evaders[i, column] = state.evaders[i + 1, column]
    state.alive[0] = last
