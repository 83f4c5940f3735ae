"""The value of given turns, as Python asks for it."""

from __future__ import annotations

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints, Workspace
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.maximum.multistart import search_scratch
from covey.kernels.maximum.problem import Problem
from covey.kernels.maximum.trial import evaluate
from covey.kernels.minimum.inner_minimum import inner_minimum


@compiled
def minimum_over_sequences(
    paths: Floats,
    pursuit: Pursuit,
    total: bool,
    bound: float,
    sequence: Ints,
    workspace: Workspace,
) -> float:
    """Return the inner minimum on given paths if it is below `bound`, else `bound`.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    total
        Whether the sum of all capture times is minimised; else the last capture.
    bound
        inf, or an upper bound.
    sequence
        (n,) the order that attains the minimum; modified in place where one beats the bound.
    workspace
        With room for n evaders, and for sums where `total`; modified in place.
    """
    scratch = search_scratch(workspace).ascent.inner
    value, _ = inner_minimum(paths, pursuit, total, bound, sequence, scratch)
    return value


@compiled
def mean_over_draws(problem: Problem, turns: Floats, workspace: Workspace) -> float:
    """Return the mean over the drawn sequences at given turns (n,)."""
    scratch = search_scratch(workspace).ascent
    return evaluate(problem, turns, scratch.single, scratch.here)
