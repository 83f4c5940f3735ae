"""A local maximum of the value of a contingent plan, by sequential quadratic programming.

Constraint generation over the branches of the tree, as `maximum.ascent.sqp` does over the sequences
of an open-loop plan. A branch depends on few turns, so each quadratic programme is one in the turns
of the working set's branches alone; all other turns stay as they are.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import (
    GO_ON,
    Workspace,
)
from covey.kernels.contingent.branch import fly_branch
from covey.kernels.contingent.local_model import fit
from covey.kernels.contingent.minimum import tree_minimum
from covey.kernels.contingent.scratch import TreeScratch
from covey.kernels.contingent.tree import Tree
from covey.kernels.maximum.ascent.curvature import multipliers_changed
from covey.kernels.maximum.ascent.local_model import (
    best_step,
    corrected_step,
    power_of_two_scale,
)
from covey.kernels.maximum.ascent.step import MIN_GAIN_RATIO
from covey.kernels.maximum.ascent.trial import MIN_RADIUS, updated_radius
from covey.kernels.maximum.problem import (
    CONVERGED,
    STALLED,
    STEPS_USED_UP,
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.working_set import WorkingSet, add
from covey.kernels.minimum.inner_minimum import InnerScratch, inner_scratch


class Aim(NamedTuple):
    """What a step of the model starts from and promises."""

    value: float  # at the iterate
    predicted: float
    radius: float  # of the trust region, radians
    scale: float  # power of two that the times are multiplied by


@entry
def ascend_tree(
    problem: Problem,
    tree: Tree,
    options: Options,
    branches: WorkingSet,
    scratch: TreeScratch,
    workspace: Workspace,
) -> tuple[float, int, int, int]:
    """Ascend to a local maximum of the minimum over all capture sequences.

    Parameters
    ----------
    problem
        The evaders (n) and the pursuit; the objective is the last capture.
    tree
        Of n evaders; its turns are modified in place.
    options
        First radius of the trust region, tolerance, largest number of steps.
    branches
        The working set, which may be empty; modified in place.
    scratch
        For trees of this size; modified in place.
    workspace
        With room for n evaders; modified in place. Its flag ends the ascent early.

    Returns
    -------
    tuple of float, int, int, int
        The exact value, which is never below that of the given turns; CONVERGED, STALLED or
        STEPS_USED_UP; steps; interceptions.
    """
    inner = inner_scratch(workspace)
    value, interceptions = _start(problem, tree, branches, scratch, inner)
    status, steps, radius, reweighted = STEPS_USED_UP, 0, options.radius, False
    while status == STEPS_USED_UP and steps < options.max_steps and workspace.stop[0] == GO_ON:
        scale = power_of_two_scale(value)
        size = fit(problem, tree, branches, scale, scratch)
        iterate = Iterate(scratch.iterate[:size], branches)
        predicted = best_step(iterate, scratch.here, radius, scale, scratch.model)
        if predicted - value <= options.tolerance * value:
            if reweighted or not multipliers_changed(branches, scratch.model):
                status = CONVERGED
            reweighted = True
            continue
        steps += 1
        trial = _take_step(problem, tree, iterate, Aim(value, predicted, radius, scale), scratch)
        longest, added = _longest_change(tree, size, scratch), False
        if trial > value:
            trial, added, more = _make_exact(problem, tree, branches, trial, scratch, inner)
            interceptions += more
        gain_ratio = (trial - value) / (predicted - value)
        if trial > value or not added:  # else the model lacked a branch
            radius = updated_radius(radius, gain_ratio, longest)
        if trial > value:
            _accept(tree, size, scratch)
            value, reweighted = trial, False
        if radius < MIN_RADIUS:
            status = STALLED
    for s in range(branches.used[0]):
        branches.values[s] = scratch.here[s]
    return value, status, steps, interceptions


@compiled
def _start(
    problem: Problem,
    tree: Tree,
    branches: WorkingSet,
    scratch: TreeScratch,
    inner: InnerScratch,
) -> tuple[float, int]:
    """Return the exact value of the first turns; the worst sequence enters the working set."""
    for k in range(len(tree.turns)):
        scratch.trial[k] = tree.turns[k]
    bound = _evaluate(problem, tree, branches, scratch)
    value, _, interceptions = _make_exact(problem, tree, branches, bound, scratch, inner)
    return value, interceptions


@compiled
def _evaluate(problem: Problem, tree: Tree, branches: WorkingSet, scratch: TreeScratch) -> float:
    """Write the last capture of each branch at the trial; return the least."""
    least, n = math.inf, len(problem.evaders)
    at_trial = Tree(scratch.trial, tree.depth, tree.sizes)
    for s in range(branches.used[0]):
        value = fly_branch(problem, at_trial, branches.sequences[s, :n], scratch.branch)
        scratch.there[s] = value
        least = min(least, value)
    return least


@compiled
def _make_exact(
    problem: Problem,
    tree: Tree,
    branches: WorkingSet,
    bound: float,
    scratch: TreeScratch,
    inner: InnerScratch,
) -> tuple[float, bool, int]:
    """Return the exact value of the trial, where `bound` is the minimum over the working set.

    Returns also whether a branch was added because it is below the bound; interceptions.
    """
    at_trial, n = Tree(scratch.trial, tree.depth, tree.sizes), len(problem.evaders)
    worst = scratch.sequence[:n]
    least, interceptions = tree_minimum(problem, at_trial, bound, worst, scratch.levels, inner)
    if least < bound:
        scratch.there[add(branches, worst, scratch.there)] = least
    return least, least < bound, interceptions


@compiled
def _take_step(
    problem: Problem, tree: Tree, iterate: Iterate, aim: Aim, scratch: TreeScratch
) -> float:
    """Write the trial, corrected where it falls short; return its value on the working set."""
    size, branches = len(iterate.turns), iterate.working_set
    value = _try_step(problem, tree, branches, size, scratch)
    short = value - aim.value < MIN_GAIN_RATIO * (aim.predicted - aim.value)
    if branches.used[0] == 1 or not short:
        return value
    for k in range(len(tree.turns)):
        scratch.first_trial[k] = scratch.trial[k]
    moved = scratch.model.eigenvalues[:size]
    for k in range(size):
        moved[k] = scratch.trial[scratch.variables[k]]
    corrected_step(iterate, moved, scratch.there, aim.radius, aim.scale, scratch.model)
    corrected = _try_step(problem, tree, branches, size, scratch)
    if corrected > value:
        return corrected
    for k in range(len(tree.turns)):
        scratch.trial[k] = scratch.first_trial[k]
    return _evaluate(problem, tree, branches, scratch)


@compiled
def _try_step(
    problem: Problem, tree: Tree, branches: WorkingSet, size: int, scratch: TreeScratch
) -> float:
    """Write the turns after the model's step to the trial; return their value on the branches."""
    for k in range(len(tree.turns)):
        scratch.trial[k] = tree.turns[k]
    for k in range(size):
        turn = scratch.iterate[k] + scratch.model.step[k]
        scratch.trial[scratch.variables[k]] = min(max(turn, -math.pi), math.pi)
    return _evaluate(problem, tree, branches, scratch)


@inlined
def _longest_change(tree: Tree, size: int, scratch: TreeScratch) -> float:
    """Return the largest change of a turn by the trial, radians."""
    longest = 0.0
    for k in range(size):
        turn = scratch.variables[k]
        longest = max(longest, abs(scratch.trial[turn] - tree.turns[turn]))
    return longest


@inlined
def _accept(tree: Tree, size: int, scratch: TreeScratch) -> None:
    """Make the trial the iterate."""
    for k in range(size):
        turn = scratch.variables[k]
        tree.turns[turn] = scratch.trial[turn]
