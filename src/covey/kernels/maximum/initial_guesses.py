"""Initial guesses of ascents: flight straight away, random turns, variations of the best plans."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled
from covey.kernels.arrays import GO_ON, Floats, Matrix, Vector
from covey.kernels.capture.path import HEADING, TURN_RATE, X, Y, wrapped
from covey.kernels.maximum.ascent.trial import AscentScratch
from covey.kernels.maximum.local_maximum import exact_value
from covey.kernels.maximum.problem import Problem

CANDIDATES = 8
"""Turn vectors that are evaluated for each guess; the ascent begins at the best of them."""

N_RANDOM = 8
"""Guesses that don't depend on what was found, before the first that varies a plan."""

BATCH = 4
"""Guesses that vary the same plans, so that their ascents can run in parallel."""

ELITE = 3
"""How many of the best plans are varied in turn."""

_SMALL = 3  # teams up to this size gain more from random guesses than from variations
_HALF_TURN_RIGHT = 1e-9 - math.pi
_MAX_VARIED = 3  # evaders that turn elsewhere than in the plan that is varied


class Elite(NamedTuple):
    """The best plans so far, the best plan first."""

    values: Vector  # (ELITE,) -inf where there is none
    turns: Matrix  # (ELITE, n)


class Guesses(NamedTuple):
    """What a range of initial guesses is made from."""

    uniforms: Matrix  # (CANDIDATES * (guesses - 1), n) random numbers in [-1, 1]
    elite: Elite  # modified in place after each batch
    first: int  # number of the first guess
    size: int  # how many guesses


def new_elite(n: int) -> Elite:
    """Allocate room for the best plans of up to n evaders, none yet."""
    return Elite(np.full(ELITE, -math.inf), np.zeros((ELITE, n)))


@compiled
def insert(elite: Elite, value: float, turns: Floats) -> None:
    """Insert a plan among the best, unless a plan with the same value is there."""
    n = len(turns)
    for k in range(ELITE):
        if abs(value - elite.values[k]) <= 1e-9 * abs(value):
            return
    rank = ELITE
    while rank > 0 and elite.values[rank - 1] < value:
        rank -= 1
    if rank == ELITE:
        return
    for k in range(ELITE - 1, rank, -1):
        elite.values[k] = elite.values[k - 1]
        for i in range(n):
            elite.turns[k, i] = elite.turns[k - 1, i]
    elite.values[rank] = value
    for i in range(n):
        elite.turns[rank, i] = turns[i]


@compiled
def make_guess(
    problem: Problem,
    guesses: Guesses,
    number: int,
    candidate: Floats,
    turns: Floats,
    scratch: AscentScratch,
) -> None:
    """Write the initial guess of a number.

    Guess 0 is flight straight away from the disk's centre. Guesses 1 to 7 take the best of
    `CANDIDATES` random turn vectors, half of them small turns. Each later guess varies a plan of
    the elite: a few evaders turn elsewhere. Teams of up to three keep to random guesses.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective.
    guesses
        Random numbers and elite.
    number
        Of the guess, from 0.
    candidate
        (n,) scratch.
    turns
        (n,) the guess, radians in [-π, π]; modified in place.
    scratch
        Of the exact value.
    """
    if number == 0:
        _away(problem, turns)
        return
    elite = guesses.elite
    varying = number >= N_RANDOM and len(turns) > _SMALL and elite.values[0] > -math.inf
    best = -math.inf
    for row in range((number - 1) * CANDIDATES, number * CANDIDATES, 2 if varying else 1):
        if best > -math.inf and scratch.stop[0] != GO_ON:
            break
        if varying:
            _vary(problem.evaders, guesses, row, number % ELITE, candidate)
        else:
            _turn_at_random(problem, guesses.uniforms[row], row % 2 == 0, candidate)
        value = exact_value(problem, candidate, best, scratch)
        if value > best:
            best = value
            for i in range(len(turns)):
                turns[i] = candidate[i]


@compiled
def _turn_at_random(problem: Problem, uniforms: Floats, small: bool, candidate: Floats) -> None:
    """Write random turns: any turns from flight straight away, or `small` turns of the heading.

    An evader that is caught while it turns gets no gradient towards a smaller turn.
    """
    _away(problem, candidate)
    for i in range(len(candidate)):
        if problem.evaders[i, TURN_RATE] > 0.0:
            if small:
                candidate[i] = math.pi * uniforms[i] ** 3
            else:
                candidate[i] = wrapped(candidate[i] + math.pi * uniforms[i])


@compiled
def _vary(evaders: Floats, guesses: Guesses, row: int, plan: int, candidate: Floats) -> None:
    """Write a variation of a plan: a row says where evaders turn, the next row which evaders."""
    elite, turns, ranks = guesses.elite, guesses.uniforms[row], guesses.uniforms[row + 1]
    n = len(candidate)
    if elite.values[plan] == -math.inf:
        plan = 0
    varied = min(max(n // 2, 1), _MAX_VARIED)
    for i in range(n):
        candidate[i] = elite.turns[plan, i]
        larger = 0
        for j in range(n):
            larger += ranks[j] > ranks[i]
        if larger < varied and evaders[i, TURN_RATE] > 0.0:
            candidate[i] = math.pi * turns[i]


@compiled
def _away(problem: Problem, turns: Floats) -> None:
    """Write the turns, the shorter way, to flight straight away from the disk's centre.

    Half turns go to the left, so that rounding doesn't decide their direction. An evader that can't
    turn keeps its heading here and in every guess, for nothing depends on its turn.
    """
    evaders, pursuit = problem.evaders, problem.pursuit
    for i in range(len(turns)):
        off_x, off_y = evaders[i, X] - pursuit.center_x, evaders[i, Y] - pursuit.center_y
        turns[i] = 0.0
        if evaders[i, TURN_RATE] > 0.0:
            turns[i] = wrapped(math.atan2(off_y, off_x) - evaders[i, HEADING])
            if turns[i] < _HALF_TURN_RIGHT:
                turns[i] = math.pi
