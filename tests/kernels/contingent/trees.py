"""The kernels of contingent plans, called with teams and disks."""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.contingent.branch import fly_branch, new_branch
from covey.kernels.contingent.delays import INTERVAL, DelaySearch, survives_delays
from covey.kernels.contingent.derivatives import (
    branch_gradient,
    branch_hessian,
    new_branch_derivatives,
)
from covey.kernels.contingent.minimum import new_levels, tree_value
from covey.kernels.contingent.tree import Tree, tree_sizes
from covey.kernels.maximum.problem import Problem
from covey.model import LastCapture
from covey.planning.border import about_center, pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.workspace import workspace


def problem_of(team, disk):
    """The game in the kernels' form."""
    team, disk = about_center(team, disk)
    objective = compiled_objective(LastCapture(), len(team))
    return Problem(team.as_rows(), pursuit_of(disk), objective)


def tree_of(team, turns, depth):
    """A tree, its turns given flat."""
    return Tree(np.array(turns), depth, tree_sizes(len(team), depth))


def branch_times(team, disk, turns, depth, sequence):
    """Capture times in the order of a sequence."""
    branch = new_branch(len(team))
    tree = tree_of(team, turns, depth)
    fly_branch(problem_of(team, disk), tree, np.array(sequence, np.int64), branch)
    return branch.times


def derivatives(team, disk, turns, depth, sequence):
    """Gradient and Hessian of the last capture, by all turns of the tree."""
    n, problem, tree = len(team), problem_of(team, disk), tree_of(team, turns, depth)
    branch, found = new_branch(n), new_branch_derivatives(n)
    fly_branch(problem, tree, np.array(sequence, np.int64), branch)
    p = branch_gradient(problem.pursuit, depth, n, branch, found)
    branch_hessian(problem.pursuit, depth, n, branch, found)
    gradient, hessian = np.zeros(len(turns)), np.zeros((len(turns), len(turns)))
    own = found.variables[:p]
    lower = np.tril(found.hessian[:p, :p])
    gradient[own] = found.gradient[:p]
    hessian[np.ix_(own, own)] = lower + np.tril(lower, -1).T
    return gradient, hessian


def value(team, disk, turns, depth, bound=math.inf):
    """The exact value of a tree, and a sequence that attains it."""
    n, sequence = len(team), np.zeros(len(team), np.int64)
    problem, tree = problem_of(team, disk), tree_of(team, turns, depth)
    least = tree_value(problem, tree, bound, sequence, new_levels(n), workspace(n))
    return least, tuple(sequence.tolist())


def survives(team, disk, turns, depth, target, finest):
    """Whether every play with delays ends after `target`, as far as the search can show."""
    n = len(team)
    search = DelaySearch(
        target,
        finest,
        new_levels(n),
        np.empty((n, INTERVAL)),
        np.empty(n, np.int64),
        np.array([0, 10**6, 0]),
    )
    return survives_delays(
        problem_of(team, disk), tree_of(team, turns, depth), search, workspace(n)
    )
