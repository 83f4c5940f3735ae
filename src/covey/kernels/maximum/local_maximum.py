"""One local maximum of the objective, whatever the objective is, and the exact value of turns."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats
from covey.kernels.capture.path import set_paths
from covey.kernels.capture.sequence import objective_value
from covey.kernels.maximum.ascent.large_team import solve_large
from covey.kernels.maximum.ascent.oracle import is_large
from covey.kernels.maximum.ascent.sqp import solve_sqp
from covey.kernels.maximum.ascent.trial import AscentScratch, expected_value
from covey.kernels.maximum.expected_value import maximise_expected
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.minimum.greedy_sequence import greedy_sequence, nearest_first
from covey.kernels.minimum.inner_minimum import earlier_by_moves, inner_minimum


@inlined
def maximise(
    problem: Problem,
    iterate: Iterate,
    options: Options,
    lower_bound: float,
    scratch: AscentScratch,
) -> tuple[float, int]:
    """Call the method that suits the objective and the team.

    `maximise_expected` has no working set and no lower bound.
    """
    if problem.objective.expected:
        return maximise_expected(problem, iterate.turns, options, scratch)
    if is_large(problem, scratch):
        return solve_large(problem, iterate, options, lower_bound, scratch)
    return solve_sqp(problem, iterate, options, lower_bound, scratch)


@compiled
def exact_value(problem: Problem, turns: Floats, cutoff: float, scratch: AscentScratch) -> float:
    """Return the exact value of turns; -inf where one sequence shows that it is <= `cutoff`.

    For large teams the value is that of a sequence, an upper bound of the exact value.
    """
    n, total, here = len(problem.evaders), problem.objective.total, scratch.here
    set_paths(problem.evaders, turns, problem.pursuit.speed, here.paths)
    if problem.objective.expected:
        return expected_value(problem, here)
    paths, sequence, times = here.paths[:n], scratch.inner.sequence[:n], scratch.inner.times[:n]
    if total:
        nearest_first(paths, problem.pursuit, -1, sequence, times)
    else:
        greedy_sequence(paths, problem.pursuit, sequence, times)
    bound = objective_value(times, total)
    if bound <= cutoff:
        return -math.inf
    if is_large(problem, scratch):
        return earlier_by_moves(paths, problem.pursuit, sequence, bound, sequence, scratch.inner)
    value, _ = inner_minimum(paths, problem.pursuit, total, bound, sequence, scratch.inner)
    return value
