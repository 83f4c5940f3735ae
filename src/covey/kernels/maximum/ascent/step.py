"""One step of an ascent: tried, corrected where the gain falls short, and made exact."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.maximum.ascent.curvature import HessianStatus
from covey.kernels.maximum.ascent.local_model import corrected_step, linearise
from covey.kernels.maximum.ascent.oracle import make_exact
from covey.kernels.maximum.ascent.trial import AscentScratch, evaluate, evaluate_sequence, try_step
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.maximum.working_set import Evaluation

_MAX_CORRECTIONS = 3
MIN_GAIN_RATIO = 0.8  # below, a step is corrected


class Points(NamedTuple):
    """The working set at the iterate and at the trial. An accepted step swaps the two."""

    here: Evaluation
    there: Evaluation


class Progress(NamedTuple):
    """What is known at the iterate."""

    value: float  # exact, or the working set's, which is an upper bound
    is_exact: bool  # by the oracle, which for large teams may miss a sequence
    lower_bound: float  # of the exact value at the first iterate; -inf: unknown
    bound_attained: bool  # the first iterate's value is the lower bound, and no step was taken
    is_reweighted: bool  # the Hessian has been weighted with the multipliers found here


class Model(NamedTuple):
    """How the local model was made, and what its best step promises."""

    scale: float  # power of two that the times are multiplied by
    hessian: HessianStatus
    predicted: float  # value of the model at its best step


@inlined
def take_step(
    problem: Problem,
    iterate: Iterate,
    options: Options,
    progress: Progress,
    model: Model,
    points: Points,
    scratch: AscentScratch,
) -> tuple[float, float]:
    """Try the step; correct it where the gain falls short, also for sequences that are added.

    Parameters
    ----------
    problem, iterate, options
        As for `solve_sqp`. The working set is modified in place.
    progress
        What is known at the iterate.
    model
        The local model, and the value that it predicts.
    points
        The working set at the iterate and at the trial, both modified in place.
    scratch
        Holds the step; the trial is written to `turns`.

    Returns
    -------
    float
        Value of the trial, exact if it is above the iterate's.
    float
        Value of the iterate. A sequence that is added may lower it.
    """
    here, there, value, working_set = points.here, points.there, progress.value, iterate.working_set
    trial = try_step(problem, iterate, there, scratch)
    for _ in range(_MAX_CORRECTIONS):
        falls_short = trial - value < MIN_GAIN_RATIO * (model.predicted - value)
        if working_set.used[0] > 1 and falls_short:
            value_to_beat = max(trial, value)
            trial = _correct(problem, iterate, options.radius, model, value_to_beat, there, scratch)
        if trial <= value:
            break
        trial, added = make_exact(problem, working_set, there, trial, scratch)
        if added < 0:
            break
        added_value = evaluate_sequence(problem, working_set, added, here)
        linearise(problem, working_set, here, added, model.scale, scratch.model)
        value = min(value, added_value)
        if trial > value:
            break
    return trial, value


@compiled
def _correct(
    problem: Problem,
    iterate: Iterate,
    radius: float,
    model: Model,
    value_to_beat: float,
    there: Evaluation,
    scratch: AscentScratch,
) -> float:
    """Replace the trial by its second-order correction where that is above `value_to_beat`."""
    n = len(iterate.turns)
    for i in range(n):
        scratch.first_turns[i] = scratch.turns[i]
    trial = scratch.turns[:n]
    corrected_step(iterate, trial, there.values, radius, model.scale, scratch.model)
    corrected = try_step(problem, iterate, there, scratch)
    if corrected > value_to_beat:
        return corrected
    for i in range(n):
        scratch.turns[i] = scratch.first_turns[i]
    return evaluate(problem, trial, iterate.working_set, there)
