"""A whole game of the strategies that come with the package, compiled."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.arrays import Floats, Ints
from covey.kernels.capture.path import HEADING, X, Y
from covey.kernels.maximum.multistart import SearchScratch
from covey.kernels.maximum.sqp import AscentScratch
from covey.kernels.minimum.last_capture import least_time
from covey.kernels.play.policy import TeamMemory, TeamPolicy, plan_again
from covey.kernels.play.replanning import commit
from covey.kernels.play.rules import (
    MOST_UPDATES,
    NOBODY,
    Rules,
    State,
    announce,
    chase_from,
    fly,
    pursuit_from,
    remove,
)


class Pages(NamedTuple):
    """The record of a game while it grows: one row a decision."""

    times: Floats  # (T,)
    guarantees: Floats  # (T,)
    evaders: Floats  # (T, N, 4) x, y, heading, turn still planned
    pursuers: Floats  # (T, 5) place, then the disk's centre and radius
    critical: Ints  # (T, N)
    intended: Ints  # (T, N)


@allocating
def blank_pages(count: int, n: int) -> Pages:
    """Pages for `count` rows of a game of n evaders, filled with what a captured evader shows."""
    return Pages(
        np.zeros(count),
        np.zeros(count),
        np.zeros((count, n, 4)),
        np.zeros((count, 5)),
        np.full((count, n), -1),
        np.full((count, n), -1),
    )


@allocating
def more_pages(pages: Pages) -> Pages:
    """Twice as many pages, the first half as before."""
    count, n = pages.critical.shape
    more = blank_pages(2 * count, n)
    more.times[:count] = pages.times
    more.guarantees[:count] = pages.guarantees
    more.evaders[:count] = pages.evaders
    more.pursuers[:count] = pages.pursuers
    more.critical[:count] = pages.critical
    more.intended[:count] = pages.intended
    return more


@compiled
def write_page(
    pages: Pages,
    page: int,
    state: State,
    rules: Rules,
    intended: Ints,
    known: int,
    scratch: AscentScratch,
) -> None:
    """Write the state, the plan that is announced, and what it is worth, to row `page`.

    `intended` holds `known` rows of the living, the order that the pursuer has in mind. Captured
    evaders stay where they were captured.
    """
    n = state.alive[0]
    pages.times[page] = state.time[0]
    for i in range(pages.critical.shape[1]):
        for column in range(3):
            pages.evaders[page, i, column] = state.resting[i, column]
    for k in range(3):
        pages.pursuers[page, 2 + k] = state.disk[k]
    pages.pursuers[page, 0], pages.pursuers[page, 1] = state.pursuer[0], state.pursuer[1]
    for row in range(n):
        i = state.ids[row]
        pages.evaders[page, i, 0] = state.evaders[row, X]
        pages.evaders[page, i, 1] = state.evaders[row, Y]
        pages.evaders[page, i, 2] = state.evaders[row, HEADING]
        pages.evaders[page, i, 3] = state.turns[row]
    for k in range(known):
        pages.intended[page, k] = state.ids[intended[k]]
    if n > 0:
        pages.guarantees[page], _ = least_time(
            state.paths,
            n,
            pursuit_from(state, rules),
            math.inf,
            scratch.found,
            scratch.worst.subsets,
        )
        for k in range(n):
            pages.critical[page, k] = state.ids[scratch.found[k]]


@allocating
def play(
    state: State,
    rules: Rules,
    team: TeamPolicy,
    memory: TeamMemory,
    margin: float,
    sequence: Ints,
    known: bool,
    recorded: bool,
    search: SearchScratch,
) -> tuple[int, Ints, Floats, int, Pages]:
    """Play a game from `state`, where `state.turns` and `memory` hold the first plan.

    The pursuer keeps to `sequence`, if one is `known`, or to the best, unless another is better by
    `margin`. Returns the number of captures, their order and times, the number of pages, the pages.
    """
    n = state.alive[0]
    order, times = np.full(n, NOBODY), np.full(n, math.inf)
    captured, page, updates = 0, 0, 0
    pages = blank_pages(256 if recorded else 1, n)
    scratch, sequence_times = search.ascent, np.empty(n)
    while state.alive[0] > 0 and state.time[0] < rules.time_limit and updates < MOST_UPDATES:
        updates += 1
        alive = state.alive[0]
        announce(state, rules)
        pursuit = chase_from(state, rules)
        commit(
            state.paths,
            alive,
            pursuit,
            memory.aim.total,
            margin,
            known,
            sequence,
            sequence_times,
            scratch,
        )
        known = True
        if recorded:
            if page + 2 > len(pages.times):
                pages = more_pages(pages)
            write_page(pages, page, state, rules, sequence, alive, scratch)
            page += 1
        taken = fly(state, rules, sequence[0], 0.0, 0.0)
        if taken != NOBODY:
            order[captured], times[captured] = state.ids[taken], state.time[0]
            captured += 1
            drop_from_sequence(sequence, alive, taken)
            remove(state, taken)
        if state.time[0] < rules.time_limit and updates < MOST_UPDATES:
            plan_again(state, rules, team, memory, taken, search)
    if recorded:
        announce(state, rules)
        write_page(pages, page, state, rules, sequence, 0, scratch)
        page += 1
    return captured, order, times, page, pages


@compiled
def drop_from_sequence(sequence: Ints, n: int, row: int) -> None:
    """Take one of the living out of a sequence of n, and number the others as `remove` does."""
    k = 0
    for j in range(n):
        i = sequence[j]
        if i != row:
            sequence[k] = i - (i > row)
            k += 1
