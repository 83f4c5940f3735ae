"""A local maximum for a large team: ascents between which the inner minimum is computed.

An ascent knows the sequences of its working set and those that moves of them reach. The inner
minimum at its end says what the turns guarantee, and adds the sequence that the ascent has missed.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import GO_ON
from covey.kernels.maximum.ascent.oracle import add_minimum
from covey.kernels.maximum.ascent.sqp import solve_sqp
from covey.kernels.maximum.ascent.trial import AscentScratch, evaluate
from covey.kernels.maximum.problem import STEPS, Iterate, Options, Problem
from covey.kernels.minimum.inner_minimum import proven_minimum

_MOST_ASCENTS, _PATIENCE = 24, 6  # in all, and without a plan that guarantees more
_MOST_STEPS = 20  # of an ascent; without the exact minimum a longer ascent may go astray
_RADIUS_AGAIN = 0.2  # first radius of all ascents but the first, radians
_ROUNDING = 1e-12  # relative


@compiled
def solve_large(
    problem: Problem,
    iterate: Iterate,
    options: Options,
    lower_bound: float,
    scratch: AscentScratch,
) -> tuple[float, int]:
    """Ascend, add the sequence that refutes the value, and ascend again, until none does.

    Parameters and what is modified are as for `solve_sqp`; an ascent that has begun may exceed
    `options.max_steps`, which is for all of them. The ascents end where the value that is
    proven comes within the tolerance of the value of the working set, too.

    Returns
    -------
    float
        What the turns guarantee: the best of all ascents, and never below that of the first turns,
        where they came with a working set or a lower bound. -inf where the flag `scratch.stop`
        ended the first ascent of other turns.
    int
        How the last ascent ended.
    """
    n, best = len(iterate.turns), lower_bound
    for i in range(n):
        scratch.incumbent[i] = iterate.turns[i]
    if iterate.working_set.used[0] > 0 and best == -math.inf:
        best, _ = _proven(problem, iterate, scratch)
    steps, steps_before = min(options.max_steps, _MOST_STEPS), scratch.counters[STEPS]
    first = Options(options.radius, options.tolerance, steps)
    again = Options(min(options.radius, _RADIUS_AGAIN), options.tolerance, steps)
    value, status = solve_sqp(problem, iterate, first, lower_bound, scratch)
    if value == lower_bound:  # the first turns are the maximum
        return value, status
    failures = 0
    for ascent in range(_MOST_ASCENTS):
        if ascent > 0:
            value, status = solve_sqp(problem, iterate, again, -math.inf, scratch)
        if scratch.stop[0] != GO_ON:
            break
        proven, claimed = _proven(problem, iterate, scratch)
        failures = failures + 1 if proven <= best else 0
        if proven > best:
            best = proven
            for i in range(n):
                scratch.incumbent[i] = iterate.turns[i]
        attained = proven >= claimed * (1.0 - options.tolerance)
        used_up = scratch.counters[STEPS] - steps_before >= options.max_steps
        if attained or used_up or failures == _PATIENCE:
            break
    if best > -math.inf:
        _return_to_incumbent(problem, iterate, best, scratch)
    return best, status


@inlined
def _return_to_incumbent(
    problem: Problem, iterate: Iterate, best: float, scratch: AscentScratch
) -> None:
    """Write the turns that guarantee `best`, and the values of the working set there."""
    working_set, here = iterate.working_set, scratch.here
    for i in range(len(iterate.turns)):
        iterate.turns[i] = scratch.incumbent[i]
    value = evaluate(problem, iterate.turns, working_set, here)
    is_missing = best < value * (1.0 - _ROUNDING)  # the worst sequence has been replaced
    if is_missing and scratch.stop[0] == GO_ON:
        add_minimum(problem, working_set, here, value, scratch)
    for s in range(working_set.used[0]):
        working_set.values[s] = here.values[s]


@inlined
def _proven(problem: Problem, iterate: Iterate, scratch: AscentScratch) -> tuple[float, float]:
    """Return what the turns guarantee, and what the working set claimed before.

    A sequence that refutes the claim is added.
    """
    working_set, here = iterate.working_set, scratch.here
    value = evaluate(problem, iterate.turns, working_set, here)
    least, _ = add_minimum(problem, working_set, here, value, scratch)
    return proven_minimum(least, len(iterate.turns), scratch.inner), value
