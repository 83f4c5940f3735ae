"""The value of given turns, as Python asks for it."""

from __future__ import annotations

from covey.kernels._jit import entry
from covey.kernels.arrays import IntVector, Matrix, Vector, Workspace
from covey.kernels.capture.path import set_paths
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.maximum.ascent.trial import ascent_scratch, evaluate
from covey.kernels.maximum.problem import Problem
from covey.kernels.minimum.inner_minimum import inner_minimum, inner_scratch


@entry
def minimum_over_sequences(
    evaders: Matrix,
    turns: Vector,
    pursuit: Pursuit,
    total: bool,
    bound: float,
    sequence: IntVector,
    workspace: Workspace,
) -> float:
    """Return the inner minimum at given turns if it is below `bound`, else `bound`.

    Parameters
    ----------
    evaders
        (n, EVADER).
    turns
        (n,) signed turns, radians.
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
    scratch = inner_scratch(workspace)
    paths = scratch.paths[: len(turns)]
    set_paths(evaders, turns, pursuit.speed, paths)
    value, _ = inner_minimum(paths, pursuit, total, bound, sequence, scratch)
    return value


@entry
def mean_over_draws(problem: Problem, turns: Vector, workspace: Workspace) -> float:
    """Return the mean over the drawn sequences at given turns (n,)."""
    scratch = ascent_scratch(workspace)
    return evaluate(problem, turns, scratch.single, scratch.here)
