"""Multistart: ascents from many initial guesses, which learn from the best plans so far."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import GO_ON, Floats, Matrix, Workspace, floats, rows
from covey.kernels.maximum.ascent.trial import AscentScratch, ascent_scratch
from covey.kernels.maximum.initial_guesses import (
    BATCH,
    ELITE,
    Elite,
    Guesses,
    insert,
    make_guess,
)
from covey.kernels.maximum.local_maximum import maximise
from covey.kernels.maximum.problem import (
    CONVERGED,
    INTERCEPTIONS,
    STEPS,
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.working_set import copy_working_set, working_set_scratch

RADIUS_RANDOM = 0.6
"""First trust-region radius of an ascent from an initial guess, radians."""

RADIUS_WARM = 0.2
"""The same from a plan of a moment ago, with its working set."""

RADIUS_UNKNOWN_SET = 0.02
"""The same from turns whose working set is unknown. Until the critical sequences are met, longer
steps may leap from one maximum to another."""


class SearchScratch(NamedTuple):
    """Arrays of a search for up to n evaders."""

    ascent: AscentScratch
    candidate: Floats  # (n,)
    iterate: Iterate  # of the present ascent
    batch: Elite  # (BATCH,) results of the present batch
    elite: Elite


@inlined
def search_scratch(workspace: Workspace) -> SearchScratch:
    """Carve the scratch of searches."""
    n = workspace.size
    return SearchScratch(
        ascent_scratch(workspace),
        floats(workspace, n),
        Iterate(floats(workspace, n), working_set_scratch(workspace)),
        Elite(floats(workspace, BATCH), rows(workspace, BATCH)),
        Elite(floats(workspace, ELITE), rows(workspace, ELITE)),
    )


@entry
def multistart(
    problem: Problem,
    guesses: Guesses,
    options: Options,
    best: float,
    iterate: Iterate,
    workspace: Workspace,
) -> tuple[float, int, int, int]:
    """Ascend from a range of initial guesses.

    Among equals the first plan wins, so that a team doesn't change its plan for nothing. When
    `workspace.stop` is set, the present ascent ends early and no other begins; the first guess is
    always evaluated.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective.
    guesses
        The range, its random numbers, and the elite, which the results of each whole batch enter.
    options
        Of each ascent.
    best
        Value of the best plan so far; -inf: none.
    iterate
        (n,) turns and working set of the best plan. Overwritten by a plan that is clearly better.
    workspace
        With room for n evaders; modified in place.

    Returns
    -------
    tuple of float, int, int, int
        Value of the best plan; how its ascent ended, CONVERGED where no guess led above `best`;
        steps; interceptions.
    """
    scratch = search_scratch(workspace)
    n, status, batch = len(iterate.turns), CONVERGED, scratch.batch
    turns = scratch.iterate.turns[:n]
    found = Iterate(turns, scratch.iterate.working_set)
    for k in range(guesses.size):
        if k > 0 and scratch.ascent.stop[0] != GO_ON:
            break
        make_guess(
            problem, guesses, guesses.first + k, scratch.candidate[:n], turns, scratch.ascent
        )
        found.working_set.used[0] = 0
        value, ended = maximise(problem, found, options, -math.inf, scratch.ascent)
        if is_better(value, best):
            best, status = value, ended
            copy_iterate(found, iterate)
        batch.values[k % BATCH] = value
        for i in range(n):
            batch.turns[k % BATCH, i] = turns[i]
        if k % BATCH == BATCH - 1:
            for j in range(BATCH):
                insert(guesses.elite, batch.values[j], batch.turns[j, :n])
    counters = scratch.ascent.counters
    return best, status, counters[STEPS], counters[INTERCEPTIONS]


@entry
def refine(
    problem: Problem,
    uniforms: Matrix,
    restarts: int,
    options: Options,
    lower_bound: float,
    iterate: Iterate,
    workspace: Workspace,
) -> tuple[float, int, int, int]:
    """Improve an iterate, from its own turns and from other initial guesses.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective.
    uniforms, restarts
        Random numbers of the other initial guesses, see `Guesses`, and how many guesses there are.
    options
        Of the ascent from the iterate. The other ascents differ in their first radius.
    lower_bound
        Of the value of the given turns, see `solve_sqp`; -inf: unknown.
    iterate
        (n,) turns and working set; modified in place.
    workspace
        With room for n evaders; modified in place.

    Returns
    -------
    tuple of float, int, int, int
        The exact value, which is never below that of the given turns; how the last ascents ended;
        steps; interceptions.
    """
    scratch = search_scratch(workspace)
    value, status = maximise(problem, iterate, options, lower_bound, scratch.ascent)
    steps, interceptions = scratch.ascent.counters[STEPS], scratch.ascent.counters[INTERCEPTIONS]
    if restarts > 0:
        guesses = Guesses(uniforms, scratch.elite, 0, restarts)
        for k in range(ELITE):
            guesses.elite.values[k] = -math.inf
        insert(guesses.elite, value, iterate.turns)
        options = Options(RADIUS_RANDOM, options.tolerance, options.max_steps)
        value, status, more, cost = multistart(problem, guesses, options, value, iterate, workspace)
        steps, interceptions = steps + more, interceptions + cost
    return value, status, steps, interceptions


@compiled
def copy_iterate(source: Iterate, target: Iterate) -> None:
    """Copy turns and working set."""
    for i in range(len(source.turns)):
        target.turns[i] = source.turns[i]
    copy_working_set(source.working_set, len(source.turns), target.working_set)


@compiled
def is_better(value: float, best: float) -> bool:
    """Return whether a plan is clearly better than the best plan so far (-inf: none)."""
    return value > best + 1e-10 * abs(best) or best == -math.inf
