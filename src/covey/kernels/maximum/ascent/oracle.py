"""The oracle of constraint generation: which capture sequence the working set lacks.

The inner minimum answers. During an ascent of a large team moves of the lowest sequences answer
instead, in a fraction of the time, and the inner minimum at the end, see `large_team`.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats
from covey.kernels.maximum.ascent.trial import AscentScratch, evaluate_sequence
from covey.kernels.maximum.problem import INNER_SOLVES, INTERCEPTIONS, Problem
from covey.kernels.maximum.working_set import Evaluation, WorkingSet, add
from covey.kernels.minimum.inner_minimum import earlier_by_moves, inner_minimum

_TRIED = 4  # lowest sequences of the working set, at which moves begin


@compiled
def make_exact(
    problem: Problem,
    working_set: WorkingSet,
    point: Evaluation,
    bound: float,
    scratch: AscentScratch,
) -> tuple[float, int]:
    """Return the inner minimum, where `bound` is the minimum over the working set.

    Returns also the row of the sequence that is added because it is below the bound, or -1. For
    large teams the value is the least that moves find, an upper bound of the inner minimum.
    """
    if is_large(problem, scratch):
        least = _least_by_moves(problem, working_set, point, bound, scratch)
        return least, _add_worst(problem, working_set, point, least < bound, scratch)
    return add_minimum(problem, working_set, point, bound, scratch)


@compiled
def add_minimum(
    problem: Problem,
    working_set: WorkingSet,
    point: Evaluation,
    bound: float,
    scratch: AscentScratch,
) -> tuple[float, int]:
    """As `make_exact`, by the inner minimum for teams of any size."""
    n, inner = len(problem.evaders), scratch.inner
    least, interceptions = inner_minimum(
        point.paths[:n],
        problem.pursuit,
        problem.objective.total,
        bound,
        inner.sequence[:n],
        inner,
    )
    scratch.counters[INNER_SOLVES] += 1
    scratch.counters[INTERCEPTIONS] += interceptions
    return least, _add_worst(problem, working_set, point, least < bound, scratch)


@inlined
def is_large(problem: Problem, scratch: AscentScratch) -> bool:
    """Whether the inner minimum takes too long to be asked at each step."""
    return not problem.objective.total and len(problem.evaders) >= scratch.inner.fewest_walking


@inlined
def _add_worst(
    problem: Problem,
    working_set: WorkingSet,
    point: Evaluation,
    missing: bool,
    scratch: AscentScratch,
) -> int:
    """Add the sequence that the oracle found, if it is missing; return its row, or -1."""
    if not missing:
        return -1
    worst = scratch.inner.sequence[: len(problem.evaders)]
    added = add(working_set, worst, point.values)
    evaluate_sequence(problem, working_set, added, point)
    return added


@compiled
def _least_by_moves(
    problem: Problem,
    working_set: WorkingSet,
    point: Evaluation,
    bound: float,
    scratch: AscentScratch,
) -> float:
    """Return the least that moves of the lowest sequences reach; `inner.sequence` attains it."""
    n, inner, least, lowest = len(problem.evaders), scratch.inner, bound, -math.inf
    paths, worst = point.paths[:n], inner.sequence[:n]
    if bound == math.inf:
        least = earlier_by_moves(paths, problem.pursuit, worst[:0], bound, worst, inner)
    for _ in range(_TRIED):
        row = _next_lowest(working_set.used[0], point.values, lowest)
        if row < 0:
            break
        start, lowest = working_set.sequences[row, :n], point.values[row]
        least = earlier_by_moves(paths, problem.pursuit, start, least, worst, inner)
    return least


@inlined
def _next_lowest(used: int, values: Floats, lowest: float) -> int:
    """Return the row of the least value above `lowest`, or -1."""
    row, least = -1, math.inf
    for s in range(used):
        if lowest < values[s] < least:
            row, least = s, values[s]
    return row
