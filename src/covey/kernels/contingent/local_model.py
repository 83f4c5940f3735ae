"""The local model of a tree's value, in the turns that the working set's branches depend on.

All other turns stay as they are, so the quadratic programme of a step is small.
"""

from __future__ import annotations

from covey.kernels._jit import compiled
from covey.kernels.contingent.branch import fly_branch
from covey.kernels.contingent.derivatives import branch_gradient, branch_hessian
from covey.kernels.contingent.scratch import TreeScratch
from covey.kernels.contingent.tree import Tree
from covey.kernels.linalg.symmetric import cholesky, shifted_cholesky
from covey.kernels.maximum.ascent.curvature import FARTHEST, penalise
from covey.kernels.maximum.problem import Problem
from covey.kernels.maximum.working_set import WorkingSet

_NEGLIGIBLE = 1e-12  # of the multipliers


@compiled
def fit(
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
    floor = steepest / FARTHEST
    if cholesky(model.hessian, size, floor, model.factor):
        return
    for a in range(size):
        for b in range(a + 1):
            model.convex_hessian[a, b] = model.hessian[a, b]
    penalise(size, branches, scratch.here, scale, model)
    shifted_cholesky(model.convex_hessian, size, floor, model.factor)
