"""A local maximum of the guaranteed value (eq. 6), by sequential quadratic programming.

Constraint generation: an ascent keeps the few sequences of its working set. At every trial that
rises, the inner minimum says exactly whether another sequence is worse, and that sequence is added.
A step maximises the local model in a trust region, which shrinks when the gain falls short.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import GO_ON
from covey.kernels.maximum.ascent.curvature import (
    HessianStatus,
    factor_hessian,
    multipliers_changed,
)
from covey.kernels.maximum.ascent.local_model import (
    ModelScratch,
    best_step,
    build_model,
    power_of_two_scale,
)
from covey.kernels.maximum.ascent.oracle import make_exact
from covey.kernels.maximum.ascent.step import Model, Points, Progress, take_step
from covey.kernels.maximum.ascent.trial import (
    MIN_RADIUS,
    AscentScratch,
    accept,
    best_escape_step,
    evaluate,
    longest_change,
    updated_radius,
)
from covey.kernels.maximum.problem import (
    CONVERGED,
    STALLED,
    STEPS,
    STEPS_USED_UP,
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.working_set import Evaluation

_ROUNDING, _REFUTED = 1e-12, 1e-9  # relative

_REBUILD, _STOP, _STEP = range(3)
"""What follows where the model predicts no gain."""


@compiled
def solve_sqp(
    problem: Problem,
    iterate: Iterate,
    options: Options,
    lower_bound: float,
    scratch: AscentScratch,
) -> tuple[float, int]:
    """Ascend to a local maximum of the minimum over all capture sequences.

    1. Start: evaluate the working set. The inner minimum is skipped where the working set attains
       `lower_bound`, which then is the value.
    2. Propose: build the local model where the iterate or the weights are new, and maximise it.
    3. Stop, where the model predicts no gain: make the value exact, weight the Hessian with the
       new multipliers, try the escapes off a saddle; then end as converged.
    4. Try the step, with second-order corrections and the sequences found missing at the trial.
    5. Accept a trial that rises. Where the gain came out as predicted, it is the last step: the
       next step would gain less than the model's error.
    6. Update the trust region. A radius below `MIN_RADIUS` ends the ascent as stalled.

    The value never falls below that of the first iterate. The flag `scratch.stop` is read before
    each step, and ends the ascent as if its steps were used up.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective (`expected` is ignored).
    iterate
        (n,) turns and the working set; modified in place.
    options
        First radius of the trust region, tolerance, largest number of steps.
    lower_bound
        Of the exact value at the given turns; -inf: unknown. A sequence that refutes the bound
        makes it -inf, as where the last plan was not flown.
    scratch
        Modified in place, `scratch.counters` too.

    Returns
    -------
    float
        The exact value at the turns.
    int
        CONVERGED, STALLED or STEPS_USED_UP.
    """
    points = Points(scratch.here, scratch.there)
    progress = _start(problem, iterate, lower_bound, points.here, scratch)
    model, is_stale = Model(1.0, HessianStatus(False, False), -math.inf), True
    status, steps = STEPS_USED_UP, 0
    while status == STEPS_USED_UP and steps < options.max_steps and scratch.stop[0] == GO_ON:
        if is_stale:
            model = _fit(problem, iterate, progress.value, points.here, scratch.model)
        model = _propose(iterate, options, progress, model, points.here, scratch.model)
        if model.predicted - progress.value <= options.tolerance * progress.value:
            action, progress, model = _without_gain(
                problem, iterate, options, progress, model, points, scratch
            )
            if action != _STEP:
                is_stale, status = True, CONVERGED if action == _STOP else STEPS_USED_UP
                continue
        steps += 1
        trial, value = take_step(problem, iterate, options, progress, model, points, scratch)
        gain_ratio = (trial - value) / (model.predicted - value)
        longest = longest_change(iterate, scratch)
        is_stale = gain_ratio > 0.0
        progress = _after_step(progress, trial, value, is_stale)
        if is_stale:
            accept(iterate, scratch)
            points = Points(points.there, points.here)
            if _is_last(iterate, options, progress, model, longest, scratch.model):
                status = CONVERGED
        options = _with_radius(options, updated_radius(options.radius, gain_ratio, longest))
        if status != CONVERGED and options.radius < MIN_RADIUS:
            status = STALLED
    scratch.counters[STEPS] += steps
    value = progress.value
    if not progress.is_exact:
        value, _ = make_exact(problem, iterate.working_set, points.here, value, scratch)
    for s in range(iterate.working_set.used[0]):
        iterate.working_set.values[s] = points.here.values[s]
    return value, status


@inlined
def _start(
    problem: Problem,
    iterate: Iterate,
    lower_bound: float,
    here: Evaluation,
    scratch: AscentScratch,
) -> Progress:
    """Evaluate the first iterate; the inner minimum is solved where the working set is empty."""
    value = evaluate(problem, iterate.turns, iterate.working_set, here)
    if value < lower_bound * (1.0 - _REFUTED):
        lower_bound = -math.inf
    attained = value <= lower_bound * (1.0 + _ROUNDING)
    if attained:
        value = lower_bound
    if iterate.working_set.used[0] == 0:
        value, _ = make_exact(problem, iterate.working_set, here, value, scratch)
        return Progress(value, True, lower_bound, attained, False)
    return Progress(value, attained, lower_bound, attained, False)


@inlined
def _fit(
    problem: Problem, iterate: Iterate, value: float, here: Evaluation, scratch: ModelScratch
) -> Model:
    """Build the local model at the iterate, and factor its Hessian, convexified where needed."""
    scale, n = power_of_two_scale(value), len(iterate.turns)
    build_model(problem, iterate.working_set, here, scale, scratch)
    hessian = factor_hessian(n, iterate.working_set, here.values, True, scale, scratch)
    return Model(scale, hessian, -math.inf)


@inlined
def _propose(
    iterate: Iterate,
    options: Options,
    progress: Progress,
    model: Model,
    here: Evaluation,
    scratch: ModelScratch,
) -> Model:
    """Write the best step; without the penalty where a convexified model predicts no gain."""
    hessian, scale = model.hessian, model.scale
    predicted = best_step(iterate, here.values, options.radius, scale, scratch)
    no_gain = predicted - progress.value <= options.tolerance * progress.value
    if hessian.convexified and no_gain:
        n, working_set = len(iterate.turns), iterate.working_set
        hessian = factor_hessian(n, working_set, here.values, False, scale, scratch)
        predicted = best_step(iterate, here.values, options.radius, scale, scratch)
    return Model(scale, hessian, predicted)


@inlined
def _without_gain(
    problem: Problem,
    iterate: Iterate,
    options: Options,
    progress: Progress,
    model: Model,
    points: Points,
    scratch: AscentScratch,
) -> tuple[int, Progress, Model]:
    """Decide what follows where the model predicts no gain.

    Returns `_REBUILD` where the working set or the weights of the Hessian change, `_STEP` where an
    escape leads off a saddle, else `_STOP`; then what is known, and the prediction.
    """
    value, working_set, lower_bound = progress.value, iterate.working_set, progress.lower_bound
    attained, is_reweighted = progress.bound_attained, progress.is_reweighted
    if not progress.is_exact:
        value, added = make_exact(problem, working_set, points.here, value, scratch)
        progress = Progress(value, True, lower_bound, attained, is_reweighted)
        if added >= 0:
            return _REBUILD, progress, model
    if attained:  # the turns were no saddle when they were found
        return _STOP, progress, model
    if not is_reweighted and multipliers_changed(working_set, scratch.model):
        return _REBUILD, Progress(value, True, lower_bound, attained, True), model
    predicted = best_escape_step(problem, iterate, points.here, points.there, model.scale, scratch)
    action = _STOP if predicted - value <= 2.0 * options.tolerance * value else _STEP
    return action, progress, Model(model.scale, model.hessian, predicted)


@inlined
def _after_step(progress: Progress, trial: float, value: float, accepted: bool) -> Progress:
    """What is known after a step from an iterate of this value, which reached the trial or not."""
    if accepted:
        return Progress(trial, True, progress.lower_bound, False, False)
    return Progress(value, progress.is_exact, progress.lower_bound, False, progress.is_reweighted)


@inlined
def _is_last(
    iterate: Iterate,
    options: Options,
    progress: Progress,
    model: Model,
    longest: float,
    scratch: ModelScratch,
) -> bool:
    """Whether an accepted step inside the trust region gained what its model predicted.

    A Hessian that was convexified, or weighted with multipliers that have changed since, may be too
    stiff to stop on; such a model ends only a warm start (`lower_bound` > -inf).
    """
    exact_model = abs(progress.value - model.predicted) <= options.tolerance * progress.value
    trusted = progress.lower_bound > -math.inf or not (
        model.hessian.convexified or multipliers_changed(iterate.working_set, scratch)
    )
    return longest < options.radius and exact_model and trusted and not model.hessian.modified


@inlined
def _with_radius(options: Options, radius: float) -> Options:
    return Options(radius, options.tolerance, options.max_steps)
