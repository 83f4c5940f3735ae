"""Arrays of an ascent on a tree, which Python allocates and owns."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from covey.kernels.arrays import IntMatrix, IntVector, Matrix, Vector
from covey.kernels.contingent.branch import Branch, new_branch
from covey.kernels.contingent.derivatives import BranchDerivatives, new_branch_derivatives
from covey.kernels.contingent.minimum import Levels, new_levels
from covey.kernels.contingent.tree import tree_sizes
from covey.kernels.library.layout import kept
from covey.kernels.linalg.active_set import QuadraticScratch
from covey.kernels.maximum.ascent.local_model import ModelScratch
from covey.kernels.maximum.working_set import WorkingSet


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


def _capacity(n: int) -> int:
    """Return how many branches a working set of n evaders holds."""
    return 4 * n + 8


def new_branches(n: int) -> WorkingSet:
    """Allocate an empty working set of branches."""
    m = _capacity(n)
    return WorkingSet(np.zeros(1, np.int64), np.empty((m, n), np.int64), np.zeros(m), np.empty(m))


def new_tree_scratch(n: int, depth: int) -> TreeScratch:
    """Allocate the scratch of ascents on trees of n evaders and a depth."""
    turns = int(tree_sizes(n, depth)[0])
    m, p, r = _capacity(n), n * (n + 1) // 2, _most_variables(n, depth, turns)
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
        most += min(nodes, _capacity(n)) * (n - level)
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
