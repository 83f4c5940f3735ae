"""A trial of an ascent: the step taken, its value, the best escape, the next trust region."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints, Workspace, floats, ints
from covey.kernels.capture.path import set_paths
from covey.kernels.capture.sequence import capture_times, objective_value
from covey.kernels.maximum.ascent.curvature import escape_count, escape_step
from covey.kernels.maximum.ascent.local_model import ModelScratch, model_scratch
from covey.kernels.maximum.problem import COUNTERS, Iterate, Problem
from covey.kernels.maximum.working_set import (
    Evaluation,
    WorkingSet,
    evaluation_scratch,
    working_set_scratch,
)
from covey.kernels.minimum.inner_minimum import InnerScratch, inner_scratch

MIN_RADIUS = 1e-9
"""An ascent ends when its trust region is smaller, radians."""


class AscentScratch(NamedTuple):
    """Arrays of an ascent with up to n evaders and m sequences."""

    inner: InnerScratch
    here: Evaluation
    there: Evaluation  # at the trial
    turns: Floats  # (n,) of the trial
    first_turns: Floats  # (n,) of the trial before its correction
    incumbent: Floats  # (n,) of the best ascent of a large team
    model: ModelScratch
    single: WorkingSet  # one row, which stands for a mean over drawn sequences
    counters: Ints  # (COUNTERS,) steps, inner solves, interceptions of this call
    stop: Ints  # (1,) of the workspace


@inlined
def ascent_scratch(workspace: Workspace) -> AscentScratch:
    """Carve the scratch of ascents, before all else."""
    n = workspace.size
    scratch = AscentScratch(
        inner_scratch(workspace),
        evaluation_scratch(workspace),
        evaluation_scratch(workspace),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        model_scratch(workspace),
        working_set_scratch(workspace),
        ints(workspace, COUNTERS),
        workspace.stop,
    )
    scratch.single.used[0], scratch.single.weights[0] = 1, 1.0
    for k in range(COUNTERS):
        scratch.counters[k] = 0
    return scratch


@compiled
def evaluate(
    problem: Problem, turns: Floats, working_set: WorkingSet, evaluation: Evaluation
) -> float:
    """Write the paths of the turns and the objective of each sequence; return the value.

    The value is the minimum over the working set, an upper bound of the exact value, or the exact
    mean over the drawn sequences.
    """
    set_paths(problem.evaders, turns, problem.pursuit.speed, evaluation.paths)
    if problem.objective.expected:
        return expected_value(problem, evaluation)
    least = math.inf
    for s in range(working_set.used[0]):
        least = min(least, evaluate_sequence(problem, working_set, s, evaluation))
    return least


@compiled
def expected_value(problem: Problem, evaluation: Evaluation) -> float:
    """Write the mean over the drawn sequences to `evaluation.values[0]`, and return it.

    `evaluation.paths` must have been set; `evaluation.times[0]` is scratch.
    """
    draws, n, value = problem.objective.draws, len(problem.evaders), 0.0
    times = evaluation.times[0, :n]
    for s in range(draws.used[0]):
        capture_times(evaluation.paths, problem.pursuit, draws.sequences[s, :n], times)
        value += draws.probabilities[s] * objective_value(times, problem.objective.total)
    evaluation.values[0] = value
    return value


@inlined
def evaluate_sequence(
    problem: Problem, working_set: WorkingSet, s: int, evaluation: Evaluation
) -> float:
    """Write the capture times and the objective of sequence s; return the objective."""
    n = len(problem.evaders)
    times = evaluation.times[s, :n]
    capture_times(evaluation.paths, problem.pursuit, working_set.sequences[s, :n], times)
    evaluation.values[s] = objective_value(times, problem.objective.total)
    return evaluation.values[s]


@compiled
def try_step(
    problem: Problem, iterate: Iterate, there: Evaluation, scratch: AscentScratch
) -> float:
    """Write the turns after the model's step to `scratch.turns`; return their value.

    As `evaluate`: the value of the working set is an upper bound of the exact value.
    """
    n = len(iterate.turns)
    for i in range(n):
        scratch.turns[i] = min(max(iterate.turns[i] + scratch.model.step[i], -math.pi), math.pi)
    return evaluate(problem, scratch.turns[:n], iterate.working_set, there)


@compiled
def best_escape_step(
    problem: Problem,
    iterate: Iterate,
    here: Evaluation,
    there: Evaluation,
    scale: float,
    scratch: AscentScratch,
) -> float:
    """Write the escape of the largest value, see `curvature`; return that value.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective.
    iterate
        (n,) turns and working set.
    here
        The working set at the iterate.
    there
        Modified in place.
    scale
        Power of two that the times are multiplied by.
    scratch
        The escape is written to `model.step`, and the last that was tried to `turns`.

    Returns
    -------
    float
        The value after the escape; -inf where there is none.
    """
    n, best, highest = len(iterate.turns), -1, -math.inf
    count = escape_count(n, iterate.working_set, here.values, scale, scratch.model)
    for escape in range(count):
        escape_step(escape, n, scratch.model)
        value = try_step(problem, iterate, there, scratch)
        if value > highest:
            best, highest = escape, value
    escape_step(best, n, scratch.model)
    return highest


@inlined
def longest_change(iterate: Iterate, scratch: AscentScratch) -> float:
    """Return the largest change of a turn by the trial, radians."""
    longest = 0.0
    for i in range(len(iterate.turns)):
        longest = max(longest, abs(scratch.turns[i] - iterate.turns[i]))
    return longest


@inlined
def accept(iterate: Iterate, scratch: AscentScratch) -> None:
    """Make the trial the iterate."""
    for i in range(len(iterate.turns)):
        iterate.turns[i] = scratch.turns[i]


@inlined
def updated_radius(radius: float, gain_ratio: float, longest: float) -> float:
    """Return the next trust-region radius.

    Parameters
    ----------
    radius
        Of the step that was tried, radians.
    gain_ratio
        Actual over predicted gain.
    longest
        The largest change of a turn by the step, radians.
    """
    if gain_ratio < 0.25:
        return (0.7 if gain_ratio > -1.0 else 0.35) * longest
    if gain_ratio > 0.7:
        return min(max(radius, 1.5 * longest), math.pi)
    return radius
