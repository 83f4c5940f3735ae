"""A whole game of the strategies that come with the package, compiled, and the log of a game."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import (
    GO_ON,
    IntMatrix,
    IntVector,
    Matrix,
    Tensor,
    Vector,
    Workspace,
)
from covey.kernels.capture.path import HEADING, X, Y
from covey.kernels.library.layout import kept
from covey.kernels.maximum.working_set import without
from covey.kernels.minimum.inner_minimum import (
    InnerScratch,
    earlier_by_moves,
    inner_minimum,
    inner_scratch,
    proven_minimum,
)
from covey.kernels.play.commitment import Commitment, commit
from covey.kernels.play.policy import ReplanOptions, TeamMemory, promised_time, replan_if_due
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

CAPTURES, ROWS, UPDATES = range(3)
"""Slots of a log's counters."""


@kept
class GameLog(NamedTuple):
    """The captures of a game, and its course: a row for each decision, T rows of them at most."""

    counters: IntVector  # (3,) captures, rows, updates
    order: IntVector  # (N,) captured evaders
    capture_times: Vector  # (N,)
    times: Vector  # (T,)
    guarantees: Vector  # (T,)
    evaders: Tensor  # (T, N, 4) x, y, heading, turn still planned
    pursuers: Matrix  # (T, 5) position, then the disk's centre and radius
    critical: IntMatrix  # (T, N)
    intended: IntMatrix  # (T, N)


_COURSE = ("times", "guarantees", "evaders", "pursuers", "critical", "intended")


def allocate_log(rows: int, n: int) -> GameLog:
    """Allocate the log of a game of n evaders; rows hold what a captured evader shows. 0: none."""
    return GameLog(
        counters=np.zeros(3, np.int64),
        order=np.full(n, NOBODY),
        capture_times=np.full(n, math.inf),
        times=np.zeros(rows),
        guarantees=np.zeros(rows),
        evaders=np.zeros((rows, n, 4)),
        pursuers=np.zeros((rows, 5)),
        critical=np.full((rows, n), NOBODY),
        intended=np.full((rows, n), NOBODY),
    )


def grow_log(log: GameLog) -> GameLog:
    """Return a log of twice as many rows, the first half as before."""
    rows, n = log.critical.shape
    larger = allocate_log(2 * rows, n)
    for name in _COURSE:
        getattr(larger, name)[:rows] = getattr(log, name)
    return larger._replace(counters=log.counters, order=log.order, capture_times=log.capture_times)


def cut_log(log: GameLog) -> GameLog:
    """Return the log without the captures and rows that were not written."""
    captures, rows = int(log.counters[CAPTURES]), int(log.counters[ROWS])
    course = {name: getattr(log, name)[:rows] for name in _COURSE}
    return log._replace(
        order=log.order[:captures], capture_times=log.capture_times[:captures], **course
    )


@entry
def write_row(
    log: GameLog,
    state: State,
    rules: Rules,
    intended: IntVector,
    promised: float,
    workspace: Workspace,
) -> None:
    """Write the state, the plan that is announced and its guarantee to the log's next row.

    Captured evaders stay where they were captured.

    Parameters
    ----------
    log
        Modified in place.
    state, rules
        Of the game; the paths of the state are those of the plan.
    intended
        Rows of the living: the order that the pursuer has in mind, as far as it is known.
    promised
        A time that the plan is known to guarantee; -inf: unknown. Only a team that is too large for
        an exact minimum at every row needs it.
    workspace
        With room for all evaders; modified in place.
    """
    row, n = log.counters[ROWS], state.alive[0]
    log.counters[ROWS] += 1
    log.times[row] = state.time[0]
    for i in range(log.critical.shape[1]):
        for column in range(3):
            log.evaders[row, i, column] = state.capture_pose[i, column]
    for k in range(3):
        log.pursuers[row, 2 + k] = state.disk[k]
    log.pursuers[row, 0], log.pursuers[row, 1] = state.pursuer[0], state.pursuer[1]
    for living in range(n):
        i = state.ids[living]
        log.evaders[row, i, 0] = state.evaders[living, X]
        log.evaders[row, i, 1] = state.evaders[living, Y]
        log.evaders[row, i, 2] = state.evaders[living, HEADING]
        log.evaders[row, i, 3] = state.turns[living]
    for k in range(len(intended)):
        log.intended[row, k] = state.ids[intended[k]]
    if n > 0:
        scratch = inner_scratch(workspace)
        log.guarantees[row] = _guaranteed(state, rules, promised, scratch)
        for k in range(n):
            log.critical[row, k] = state.ids[scratch.sequence[k]]


@inlined
def _guaranteed(state: State, rules: Rules, promised: float, scratch: InnerScratch) -> float:
    """Return the guaranteed time of the plan; `scratch.sequence` is the worst sequence known."""
    n = state.alive[0]
    paths, pursuit, worst = state.paths[:n], pursuit_from(state.disk, rules), scratch.sequence[:n]
    if promised > -math.inf and n > scratch.largest_table:
        earlier_by_moves(paths, pursuit, worst[:0], math.inf, worst, scratch)
        return max(promised, 0.0)
    found, _ = inner_minimum(paths, pursuit, False, math.inf, worst, scratch)
    return proven_minimum(found, n, scratch)


@compiled
def is_over(log: GameLog, state: State, rules: Rules) -> bool:
    """Return whether everybody is captured, or the game is stopped at a limit."""
    in_time = state.time[0] < rules.time_limit and log.counters[UPDATES] < MOST_UPDATES
    return state.alive[0] == 0 or not in_time


@compiled
def log_capture(log: GameLog, state: State, row: int) -> None:
    """Log the capture of the living evader in a row, and remove the evader."""
    k = log.counters[CAPTURES]
    log.order[k], log.capture_times[k] = state.ids[row], state.time[0]
    log.counters[CAPTURES] += 1
    remove(state, row)


@entry
def play(
    state: State,
    rules: Rules,
    team: ReplanOptions,
    memory: TeamMemory,
    commitment: Commitment,
    log: GameLog,
    workspace: Workspace,
) -> bool:
    """Play a game until it is over, or until its log is full.

    1. Announce the team's plan; the pursuer chooses its sequence, or keeps it.
    2. Write a row, if the course is logged.
    3. Fly until the next update or capture, and log a capture.
    4. Let the team replan, where that is due.

    Parameters
    ----------
    state
        Of the game; `state.turns` holds the plan that is flown. Modified in place.
    rules
        Of the game.
    team, memory
        How the team replans, and what it remembers; the memory is modified in place.
    commitment
        The pursuer's sequence, modified in place. `is_chosen` must be true where a game goes on.
    log
        Modified in place. A log without rows keeps the captures only.
    workspace
        With room for all evaders; modified in place.

    Returns
    -------
    bool
        Whether the game is over. If not, call again with a log that was grown, unless
        `workspace.stop` has been set.
    """
    recorded, total = len(log.times) > 0, memory.objective.total
    while not is_over(log, state, rules):
        if workspace.stop[0] != GO_ON or (recorded and log.counters[ROWS] + 2 > len(log.times)):
            return False
        log.counters[UPDATES] += 1
        n = state.alive[0]
        sequence = commitment.sequence[:n]
        announce(state, rules)
        pursuit = pursuit_from(state.pursuer, rules)
        commit(state.paths[:n], pursuit, total, commitment, workspace)
        commitment = Commitment(commitment.margin, commitment.sequence, True)
        if recorded:
            promised = promised_time(state, team, memory)
            write_row(log, state, rules, sequence, promised, workspace)
        captured_row = fly(state, rules, sequence[0], 0.0, 0.0)
        if captured_row != NOBODY:
            log_capture(log, state, captured_row)
            without(sequence, captured_row, sequence)
        if state.time[0] < rules.time_limit and log.counters[UPDATES] < MOST_UPDATES:
            replan_if_due(state, rules, team, memory, captured_row, workspace)
    if recorded:
        announce(state, rules)
        promised = promised_time(state, team, memory)
        write_row(log, state, rules, commitment.sequence[:0], promised, workspace)
    return True
