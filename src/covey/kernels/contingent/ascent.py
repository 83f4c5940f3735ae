"""A local maximum of the value of a contingent plan, by sequential quadratic programming.

Constraint generation over the branches of the tree, as `maximum.sqp` does over the sequences of an
open-loop plan. A branch depends on few turns, so each quadratic programme is one in the turns of
the working set's branches alone; all other turns stay as they are.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import (
    GO_ON,
    IntMatrix,
    IntVector,
    Matrix,
    Vector,
    Workspace,
)
from covey.kernels.contingent.branch import Branch, fly_branch, new_branch
from covey.kernels.contingent.derivatives import (
    BranchDerivatives,
    branch_gradient,
    branch_hessian,
    new_branch_derivatives,
)
from covey.kernels.contingent.minimum import Levels, new_levels, tree_minimum
from covey.kernels.contingent.tree import Tree, tree_sizes
from covey.kernels.library.layout import kept
from covey.kernels.linalg.active_set import QuadraticScratch
from covey.kernels.linalg.symmetric import cholesky, shifted_cholesky
from covey.kernels.maximum.curvature import multipliers_changed, penalise
from covey.kernels.maximum.local_model import (
    ModelScratch,
    best_step,
    corrected_step,
    power_of_two_scale,
)
from covey.kernels.maximum.problem import (
    CONVERGED,
    STALLED,
    STEPS_USED_UP,
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.trial import MIN_RADIUS, updated_radius
from covey.kernels.maximum.working_set import WorkingSet, add
from covey.kernels.minimum.inner_minimum import InnerScratch, inner_scratch

_FARTHEST = 1e5  # radians, see `maximum.curvature`
_MIN_GAIN_RATIO = 0.8  # below, a step is corrected
_NEGLIGIBLE = 1e-12  # of the multipliers


@kept
class TreeScratch(NamedTuple):
    """Arrays of an ascent on a tree of n evaders, with up to m branches of p turns, r in all."""

    branch: Branch
    derivatives: BranchDerivatives
    levels: Levels
    sequence: IntVector  # (n,) the worst sequence
    here: Vector  # (m,) last capture of each branch at the iterate
    there: Vector  # (m,) the same at the trial
    gradients: Matrix  # (m, p) of each branch
    turns_of: IntMatrix  # (m, p) which turns a branch depends on
    lengths: IntVector  # (m,) how many
    places: IntVector  # (turns of the tree,) places among the variables, -1: none
    variables: IntVector  # (r,) turns that some branch depends on
    iterate: Vector  # (r,) their values
    trial: Vector  # (turns of the tree,)
    first_trial: Vector  # (turns of the tree,) before its correction
    model: ModelScratch  # of r turns and m branches


class Aim(NamedTuple):
    """What a step of the model starts from and promises."""

    value: float  # at the iterate
    predicted: float
    radius: float  # of the trust region, radians
    scale: float  # power of two that the times are multiplied by


def new_branches(n: int) -> WorkingSet:
    """Allocate an empty working set of branches."""
    m = 4 * n + 8
    return WorkingSet(np.zeros(1, np.int64), np.empty((m, n), np.int64), np.zeros(m), np.empty(m))


def new_tree_scratch(n: int, depth: int) -> TreeScratch:
    """Allocate the scratch of ascents on trees of n evaders and a depth."""
    turns = int(tree_sizes(n, depth)[0])
    m, p, r = 4 * n + 8, n * (n + 1) // 2, _most_variables(n, depth, turns)
    return TreeScratch(
        new_branch(n),
        new_branch_derivatives(n),
        new_levels(n),
        np.empty(n, np.int64),
        np.empty(m),
        np.empty(m),
        np.empty((m, p)),
        np.empty((m, p), np.int64),
        np.empty(m, np.int64),
        np.empty(turns, np.int64),
        np.empty(r, np.int64),
        np.empty(r),
        np.empty(turns),
        np.empty(turns),
        _new_model_scratch(m, r),
    )


def _most_variables(n: int, depth: int, turns: int) -> int:
    """Return how many turns the branches of a full working set depend on, at most."""
    nodes, most = 1, 0
    for level in range(depth + 1):
        most += min(nodes, 4 * n + 8) * (n - level)
        nodes *= n - level
    return min(most, turns)


def _new_model_scratch(m: int, r: int) -> ModelScratch:
    return ModelScratch(
        gradients=np.empty((m, r)),
        weights=np.empty(m),
        capture_rows=np.empty((1, 1)),
        slopes=np.empty((1, 1)),
        hessian=np.empty((r, r)),
        convex_hessian=np.empty((r, r)),
        factor=np.empty((r, r)),
        eigenvectors=np.empty((1, 1)),
        eigenvalues=np.empty(r),
        linear=np.empty(r),
        lower=np.empty(r),
        upper=np.empty(r),
        step=np.empty(r),
        values=np.empty(m),
        quadratic=QuadraticScratch(
            np.empty((m + 2 * r, r)),
            np.empty(r + 2, np.int64),
            np.empty(r + 2),
            np.empty((r + 2, r + 2)),
            np.empty(r + 2),
            np.empty(r + 2),
            np.empty(r),
        ),
    )


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
        size = _fit(problem, tree, branches, scale, scratch)
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
def _fit(
    problem: Problem, tree: Tree, branches: WorkingSet, scale: float, scratch: TreeScratch
) -> int:
    """Build the local model in the turns of the working set's branches; return how many there are.

    Writes values and gradients at the iterate, and the factor of the Lagrangian's Hessian, sign
    turned. A turn on which no weighted branch depends is held by the steepest slope instead.
    """
    n, count, pursuit = len(problem.evaders), branches.used[0], problem.pursuit
    total_weight, worst, size = 0.0, 0, 0
    for k in range(len(tree.turns)):
        scratch.places[k] = -1
    for s in range(count):
        scratch.here[s] = fly_branch(problem, tree, branches.sequences[s, :n], scratch.branch)
        length = branch_gradient(pursuit, tree.depth, n, scratch.branch, scratch.derivatives)
        scratch.lengths[s] = length
        total_weight += branches.weights[s]
        worst = s if scratch.here[s] < scratch.here[worst] else worst
        for k in range(length):
            turn = scratch.derivatives.variables[k]
            scratch.gradients[s, k] = scratch.derivatives.gradient[k]
            scratch.turns_of[s, k] = turn
            if scratch.places[turn] < 0:
                scratch.places[turn] = size
                scratch.variables[size] = turn
                scratch.iterate[size] = tree.turns[turn]
                size += 1
    if total_weight == 0.0:
        branches.weights[worst] = 1.0
    _scatter(problem, tree, branches, size, scale, scratch)
    _factor(branches, size, scale, scratch)
    return size


@compiled
def _scatter(
    problem: Problem,
    tree: Tree,
    branches: WorkingSet,
    size: int,
    scale: float,
    scratch: TreeScratch,
) -> None:
    """Write the branches' gradients and the Hessian in terms of the variables."""
    n, model, places = len(problem.evaders), scratch.model, scratch.places
    for a in range(size):
        for b in range(a + 1):
            model.hessian[a, b] = 0.0
    for s in range(branches.used[0]):
        model.weights[s] = branches.weights[s]
        for a in range(size):
            model.gradients[s, a] = 0.0
        for k in range(scratch.lengths[s]):
            model.gradients[s, places[scratch.turns_of[s, k]]] = scale * scratch.gradients[s, k]
        if branches.weights[s] > _NEGLIGIBLE:
            fly_branch(problem, tree, branches.sequences[s, :n], scratch.branch)
            branch_gradient(problem.pursuit, tree.depth, n, scratch.branch, scratch.derivatives)
            branch_hessian(problem.pursuit, tree.depth, n, scratch.branch, scratch.derivatives)
            weight, hessian = scale * branches.weights[s], scratch.derivatives.hessian
            for k in range(scratch.lengths[s]):
                a = places[scratch.turns_of[s, k]]
                for j in range(k + 1):
                    b = places[scratch.turns_of[s, j]]
                    model.hessian[max(a, b), min(a, b)] -= weight * hessian[k, j]


@compiled
def _factor(branches: WorkingSet, size: int, scale: float, scratch: TreeScratch) -> None:
    """Factor the Hessian; convexified or shifted where it isn't positive definite."""
    model, steepest = scratch.model, 0.0
    for a in range(size):
        model.linear[a] = 0.0
        for s in range(branches.used[0]):
            steepest = max(steepest, abs(model.gradients[s, a]))
    for a in range(size):
        if model.hessian[a, a] == 0.0:
            model.hessian[a, a] = steepest
    floor = steepest / _FARTHEST
    if cholesky(model.hessian, size, floor, model.factor):
        return
    for a in range(size):
        for b in range(a + 1):
            model.convex_hessian[a, b] = model.hessian[a, b]
    penalise(size, branches, scratch.here, scale, model)
    shifted_cholesky(model.convex_hessian, size, floor, model.factor)


@compiled
def _take_step(
    problem: Problem, tree: Tree, iterate: Iterate, aim: Aim, scratch: TreeScratch
) -> float:
    """Write the trial, corrected where it falls short; return its value on the working set."""
    size, branches = len(iterate.turns), iterate.working_set
    value = _try_step(problem, tree, branches, size, scratch)
    short = value - aim.value < _MIN_GAIN_RATIO * (aim.predicted - aim.value)
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
