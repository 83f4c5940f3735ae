"""Where ascents start: flight straight away, random turns, variations of the best plans so far."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.arrays import Floats, Pursuit, Table
from covey.kernels.capture.path import HEADING, TURN_RATE, X, Y, wrapped
from covey.kernels.maximum.local_maximum import worth
from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.sqp import AscentScratch

CANDIDATES = 8
"""Random turns that are evaluated for each start; the ascent begins at the best of them."""

BEGINNINGS = 8
"""Starts from nowhere in particular, before the first that varies what was found."""

BATCH = 4
"""Starts that know of the same plans, so that they can be followed side by side."""

ELITE = 3
"""How many of the best plans are varied in turn."""

_SMALL = 3
_HALF_TURN_RIGHT = 1e-9 - math.pi
_MOST_VARIED = 3  # evaders that turn elsewhere than in the plan that is varied


class Elite(NamedTuple):
    """The best plans so far, the best one first."""

    values: Floats  # (ELITE,) -inf where there is none
    turns: Table  # (ELITE, n)


@allocating
def make_elite(n: int) -> Elite:
    """Room for the best plans, none yet."""
    return Elite(np.full(ELITE, -math.inf), np.zeros((ELITE, n)))


@compiled
def enter(elite: Elite, n: int, value: float, turns: Floats) -> None:
    """Enter a plan among the best, unless one with the same value is there."""
    for k in range(ELITE):
        if abs(value - elite.values[k]) <= 1e-9 * abs(value):
            return
    place = ELITE
    while place > 0 and elite.values[place - 1] < value:
        place -= 1
    if place == ELITE:
        return
    for k in range(ELITE - 1, place, -1):
        elite.values[k] = elite.values[k - 1]
        for i in range(n):
            elite.turns[k, i] = elite.turns[k - 1, i]
    elite.values[place] = value
    for i in range(n):
        elite.turns[place, i] = turns[i]


@compiled
def lay_out(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    aim: Aim,
    noise: Table,
    start: int,
    elite: Elite,
    candidate: Floats,
    turns: Floats,
    scratch: AscentScratch,
) -> None:
    """Write the turns of a start to `turns`.

    Start 0 is flight straight away from the disk's centre; the other beginnings are the best of
    that flight turned by π times `CANDIDATES` rows of `noise` (numbers in [-1, 1]). Then each start
    takes one of the best plans and lets a few evaders turn elsewhere; small teams do better by
    beginning anew. `candidate` (n,) is scratch.
    """
    if start == 0:
        _away(evaders, n, pursuit, turns)
        return
    varying = start >= BEGINNINGS and n > _SMALL and elite.values[0] > -math.inf
    best = -math.inf
    for row in range((start - 1) * CANDIDATES, start * CANDIDATES, 2 if varying else 1):
        if varying:
            _vary(evaders, n, noise, row, start % ELITE, elite, candidate)
        else:
            _turn_at_random(evaders, n, pursuit, noise, row, row % 2 == 0, candidate)
        value = worth(evaders, n, pursuit, aim, candidate, best, scratch)
        if value > best:
            best = value
            for i in range(n):
                turns[i] = candidate[i]


@compiled
def _turn_at_random(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    noise: Table,
    row: int,
    little: bool,
    candidate: Floats,
) -> None:
    """Turn away from the disk and then anywhere, or from where everyone heads, rather a `little`.

    An evader that is caught while it turns doesn't learn from any gradient to turn less.
    """
    _away(evaders, n, pursuit, candidate)
    for i in range(n):
        if evaders[i, TURN_RATE] > 0.0:
            if little:
                candidate[i] = math.pi * noise[row, i] ** 3
            else:
                candidate[i] = wrapped(candidate[i] + math.pi * noise[row, i])


@compiled
def _vary(
    evaders: Table, n: int, noise: Table, row: int, plan: int, elite: Elite, candidate: Floats
) -> None:
    """Vary one of the best plans: a row of noise says to where evaders turn, the next one who."""
    if elite.values[plan] == -math.inf:
        plan = 0
    varied = min(max(n // 2, 1), _MOST_VARIED)
    for i in range(n):
        candidate[i] = elite.turns[plan, i]
        before = 0
        for j in range(n):
            before += noise[row + 1, j] > noise[row + 1, i]
        if before < varied and evaders[i, TURN_RATE] > 0.0:
            candidate[i] = math.pi * noise[row, i]


@compiled
def _away(evaders: Table, n: int, pursuit: Pursuit, turns: Floats) -> None:
    """Write the turns, the shorter way, to flight straight away from the disk's centre.

    Half turns are to the left, so that not rounding decides about them. An evader that can't turn
    keeps its heading here and in every start, for nothing depends on it.
    """
    for i in range(n):
        off_x, off_y = evaders[i, X] - pursuit.center_x, evaders[i, Y] - pursuit.center_y
        turns[i] = 0.0
        if evaders[i, TURN_RATE] > 0.0:
            turns[i] = wrapped(math.atan2(off_y, off_x) - evaders[i, HEADING])
            if turns[i] < _HALF_TURN_RIGHT:
                turns[i] = math.pi
