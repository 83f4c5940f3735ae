"""The search for a contingent plan: ascents from seeds that are made of smaller plans.

Plain restarts stay behind. An open-loop plan that everybody flies on with, whatever happens, is a
tree; so is one after whose captures those left fly the best trees of the smaller games.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from covey.kernels.arrays import Workspace
from covey.kernels.contingent.ascent import ascend_tree
from covey.kernels.contingent.scratch import new_branches
from covey.kernels.contingent.tree import Tree, answer_to, tree_sizes
from covey.kernels.maximum.multistart import is_better
from covey.kernels.maximum.problem import CONVERGED, Options, Problem
from covey.kernels.maximum.working_set import WorkingSet
from covey.model import LastCapture
from covey.model.validation import Floats
from covey.planning.compiled_objective import compiled_objective
from covey.planning.contingent.moment import Moment, after_capture, last_turn
from covey.planning.long_calls import interruptible
from covey.planning.multistart import MAX_STEPS, NONE, Ascents, Search
from covey.planning.open_loop import guess_uniforms
from covey.planning.workspace import tree_scratch

RADIUS = 0.2
"""First trust-region radius of an ascent, radians."""

TOLERANCE = 1e-7
"""An ascent ends when a step promises less than this, relative to the value."""

_WORK = 0.25
"""Interceptions that take as long as an ascent on a tree of m turns, over m³, about."""
_ROOTS = 2  # open-loop plans that trees are built on
_STARTS = 16  # of the search for each open-loop plan
_ROUNDS = 3  # trees that are built anew on the turns of the best tree, at most


class Ascent(NamedTuple):
    """Where an ascent on a tree ended, and what it took."""

    value: float
    turns: Floats  # flat, see `kernels.contingent.tree`
    branches: WorkingSet
    status: int
    starts: int
    steps: int


class Effort(NamedTuple):
    """How a search searches."""

    seed: int
    starts: int  # of each open-loop plan
    roots: int  # open-loop plans that trees are built on, at most


def problem_of(moment: Moment) -> Problem:
    """Return the problem of the last capture from a moment on."""
    objective = compiled_objective(LastCapture(), len(moment.evaders))
    return Problem(moment.evaders, moment.pursuit, objective)


def ascend(moment: Moment, depth: int, turns: Floats, branches: WorkingSet) -> Ascent:
    """Ascend from a tree, given flat. The working set is modified in place."""
    n = len(moment.evaders)
    tree = Tree(turns.copy(), depth, tree_sizes(n, depth))
    problem, options = problem_of(moment), Options(RADIUS, TOLERANCE, MAX_STEPS)

    def call(scratch: Workspace) -> tuple[float, int, int, int]:
        return ascend_tree(problem, tree, options, branches, tree_scratch(n, depth), scratch)

    value, status, steps, _ = interruptible(call, n, False, _WORK * len(turns) ** 3)
    return Ascent(value, tree.turns, branches, status, 1, steps)


def deepened(moment: Moment, depth: int, tree: Floats) -> Floats:
    """Return the tree that answers one capture more, with what all are flying already."""
    n = len(moment.evaders)
    now = tree[:n]
    parts = [now]
    for rank, time in enumerate(moment.earliest(now)):
        after, left = after_capture(moment, now, rank, time)
        answer = deepened(after, depth - 1, answer_to(tree, n, rank)) if depth > 0 else left
        parts.append(answer)
    return np.concatenate(parts)


def joined(moment: Moment, depth: int, turns: Floats, effort: Effort) -> Ascent:
    """Ascend from the tree of turns (n,) now, and of the best found after each capture."""
    parts, starts, steps = [turns], 1, 0
    for rank, time in enumerate(moment.earliest(turns)):
        after, _ = after_capture(moment, turns, rank, time)
        below = search(after, depth - 1, effort._replace(roots=1))
        parts.append(below.turns)
        starts, steps = starts + below.starts, steps + below.steps
    found = ascend(moment, depth, np.concatenate(parts), new_branches(len(turns)))
    return found._replace(starts=starts, steps=steps + found.steps)


def better(best: Ascent, other: Ascent) -> Ascent:
    """Return the better of two, the first among equals, with the cost of both."""
    chosen = other if is_better(other.value, best.value) else best
    return chosen._replace(starts=best.starts + other.starts, steps=best.steps + other.steps)


def search(moment: Moment, depth: int, effort: Effort) -> Ascent:
    """Return the best tree found for the game from a moment on, built on open-loop plans."""
    n = len(moment.evaders)
    if n == 1:
        turns = last_turn(moment)
        return Ascent(float(moment.earliest(turns)[0]), turns, new_branches(1), CONVERGED, 1, 0)
    plan, roots = open_loop_plans(moment, effort)
    if depth == 0:
        branches = new_branches(n)
        return Ascent(
            plan.value, plan.iterate.turns, branches, plan.status, plan.starts, plan.steps
        )
    found = built(moment, depth, roots, effort)
    return found._replace(starts=found.starts + plan.starts, steps=found.steps + plan.steps)


_uniforms = lru_cache(maxsize=32)(guess_uniforms)  # hundreds of searches use the same ones


def open_loop_plans(moment: Moment, effort: Effort) -> tuple[Ascents, list[Floats]]:
    """Return the best open-loop plan, and the turns of the best few, the best first."""
    uniforms = _uniforms(effort.seed, effort.starts, len(moment.evaders))
    ascents = Search(problem_of(moment), TOLERANCE, uniforms, math.inf)
    return ascents.run(NONE, effort.starts), ascents.elite[: effort.roots]


def built(moment: Moment, depth: int, roots: list[Floats], effort: Effort) -> Ascent:
    """Return the best of the trees that are built on some turns.

    Where there are several, more trees are built on the turns of the best tree while that gains.
    """
    best, *others = (joined(moment, depth, turns, effort) for turns in roots)
    for other in others:
        best = better(best, other)
    for _ in range(_ROUNDS if others else 0):
        before = best.value
        best = better(best, joined(moment, depth, best.turns[: len(roots[0])], effort))
        if not is_better(best.value, before):
            break
    return best


def deeper_and_deeper(moment: Moment, depth: int, turns: Floats, seed: int) -> Ascent:
    """Return the best tree found; each depth begins, too, with the tree of the depth before.

    The first of these trees are the turns (n,) of an open-loop plan; `depth` is at least 1.
    """
    effort, n = Effort(seed, _STARTS, _ROOTS), len(turns)
    _, roots = open_loop_plans(moment, effort)
    best = Ascent(-math.inf, turns, new_branches(n), CONVERGED, 0, 0)
    for each in range(1, depth + 1):
        flown = ascend(moment, each, deepened(moment, each - 1, best.turns), new_branches(n))
        best = better(flown, built(moment, each, roots, effort))
    return best
