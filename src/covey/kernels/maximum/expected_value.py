"""A local maximum of a mean over drawn capture sequences: Newton's method in a trust region.

No minimum is taken, so the mean is as smooth as a capture time. Its gradient is continuous. Its
Hessian is continuous unless an evader is captured at the very end of a turn.
"""

from __future__ import annotations

from covey.kernels._jit import compiled
from covey.kernels.arrays import GO_ON, Floats
from covey.kernels.capture.derivatives import add_curvature, differentiate
from covey.kernels.capture.sequence import capture_times
from covey.kernels.maximum.ascent.curvature import factor_hessian
from covey.kernels.maximum.ascent.local_model import (
    ModelScratch,
    best_step,
    captures_of,
    clear_hessian,
    power_of_two_scale,
)
from covey.kernels.maximum.ascent.trial import (
    MIN_RADIUS,
    AscentScratch,
    accept,
    best_escape_step,
    evaluate,
    longest_change,
    try_step,
    updated_radius,
)
from covey.kernels.maximum.problem import (
    CONVERGED,
    INTERCEPTIONS,
    STALLED,
    STEPS,
    STEPS_USED_UP,
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.working_set import Evaluation


@compiled
def maximise_expected(
    problem: Problem, turns: Floats, options: Options, scratch: AscentScratch
) -> tuple[float, int]:
    """Improve the turns in place to a local maximum of the mean over the drawn sequences.

    As `solve_sqp`, with a single model in place of several, and no lower bound. Returns the value,
    and CONVERGED, STALLED or STEPS_USED_UP.
    """
    n, drawn = len(turns), problem.objective.draws.used[0]
    iterate, here, there = Iterate(turns, scratch.single), scratch.here, scratch.there
    value = evaluate(problem, turns, iterate.working_set, here)
    radius, scale, moved, steps, status = options.radius, 1.0, True, 0, STEPS_USED_UP
    scratch.counters[INTERCEPTIONS] += n * drawn
    while status == STEPS_USED_UP and steps < options.max_steps and scratch.stop[0] == GO_ON:
        if moved:
            scale = power_of_two_scale(value)
            _build_model(problem, here, scale, scratch.model)
            factor_hessian(n, iterate.working_set, here.values, False, scale, scratch.model)
        predicted = best_step(iterate, here.values, radius, scale, scratch.model)
        if predicted - value <= options.tolerance * value:
            predicted = best_escape_step(problem, iterate, here, there, scale, scratch)
            if predicted - value <= 2.0 * options.tolerance * value:
                status = CONVERGED
                continue
        steps += 1
        trial = try_step(problem, iterate, there, scratch)
        scratch.counters[INTERCEPTIONS] += n * drawn
        gain_ratio = (trial - value) / (predicted - value)
        longest = longest_change(iterate, scratch)
        moved = gain_ratio > 0.0
        if moved:
            value = trial
            accept(iterate, scratch)
            here, there = there, here
        radius = updated_radius(radius, gain_ratio, longest)
        if radius < MIN_RADIUS:
            status = STALLED
    scratch.counters[STEPS] += steps
    return value, status


@compiled
def _build_model(problem: Problem, here: Evaluation, scale: float, model: ModelScratch) -> None:
    """Write gradient and Hessian, its sign turned, of the mean, as those of a single sequence.

    `here.times[0]` and the second row of the gradients are scratch.
    """
    n, draws, pursuit = len(problem.evaders), problem.objective.draws, problem.pursuit
    mean, gradient, times = model.gradients[0], model.gradients[1], here.times[0, :n]
    for i in range(n):
        mean[i] = 0.0
    clear_hessian(n, model)
    for s in range(draws.used[0]):
        sequence, share = draws.sequences[s, :n], scale * draws.probabilities[s]
        capture_times(here.paths, pursuit, sequence, times)
        captures = captures_of(here, 0, model)
        differentiate(here.paths, pursuit, sequence, problem.objective.total, captures, gradient)
        for i in range(n):
            mean[i] += share * gradient[i]
        add_curvature(here.paths, pursuit, sequence, captures, -share, model.hessian)
