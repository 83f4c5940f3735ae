"""The exact value of a contingent plan: the minimum of the last capture over all sequences.

A search in depth over the answered captures. After the last of them the plan is an open-loop plan,
and the dynamic programme of `minimum` goes on. A branch ends where its last capture is no earlier
than the least value so far.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import (
    IntMatrix,
    Ints,
    IntVector,
    Matrix,
    Workspace,
)
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import EVADER, PATH, position, set_paths
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.contingent.branch import move_on
from covey.kernels.contingent.tree import Tree, subtree
from covey.kernels.maximum.problem import Problem
from covey.kernels.minimum.inner_minimum import InnerScratch, inner_minimum, inner_scratch

# A level's numbers: where the pursuer's disk begins, and when.
CENTER_X, CENTER_Y, RADIUS, TIME = range(4)
OFFSET, CHILD = range(2)  # a level's counters: its node's turns, the next evader to be captured


class Levels(NamedTuple):
    """The nodes on the branch that is searched, by level; each row belongs to a living evader."""

    evaders: Matrix  # (n * n, EVADER) row level * n + rank
    paths: Matrix  # (n * n, PATH)
    numbers: IntMatrix  # (n, n) the evaders' numbers, ascending
    disks: Matrix  # (n, 4)
    counters: IntMatrix  # (n, 2)
    sequence: IntVector  # (n,) evaders captured so far


def new_levels(n: int) -> Levels:
    """Allocate the levels of a search for up to n evaders."""
    return Levels(
        np.empty((n * n, EVADER)),
        np.empty((n * n, PATH)),
        np.empty((n, n), np.int64),
        np.empty((n, 4)),
        np.empty((n, 2), np.int64),
        np.empty(n, np.int64),
    )


@entry
def tree_value(
    problem: Problem,
    tree: Tree,
    bound: float,
    sequence: IntVector,
    levels: Levels,
    workspace: Workspace,
) -> float:
    """Return the value of a contingent plan if it is below `bound`, else `bound`.

    Parameters are those of `tree_minimum`; the workspace has room for n evaders.
    """
    value, _ = tree_minimum(problem, tree, bound, sequence, levels, inner_scratch(workspace))
    return value


@compiled
def tree_minimum(
    problem: Problem,
    tree: Tree,
    bound: float,
    sequence: Ints,
    levels: Levels,
    scratch: InnerScratch,
) -> tuple[float, int]:
    """Return the least last capture over all sequences, if it is below `bound`.

    Parameters
    ----------
    problem
        The evaders (n) and the pursuit; the objective is the last capture.
    tree
        Of n evaders.
    bound
        inf, or an upper bound such as the least value of some sequences.
    sequence
        (n,) the order that attains the minimum; left alone where none beats the bound. Modified in
        place.
    levels
        With room for n evaders; modified in place.
    scratch
        Of the dynamic programme, likewise.

    Returns
    -------
    float
        The minimum, else `bound`.
    int
        Interceptions.
    """
    enter_root(problem, levels)
    enter(problem, tree, 0, levels)
    return minimum_from(problem, tree, 0, bound, sequence, levels, scratch)


@compiled
def minimum_from(
    problem: Problem,
    tree: Tree,
    first_level: int,
    bound: float,
    sequence: Ints,
    levels: Levels,
    scratch: InnerScratch,
) -> tuple[float, int]:
    """Return what `tree_minimum` does, for the plays from the node of a level that was entered."""
    n, least, interceptions, level = len(problem.evaders), bound, 0, first_level
    while level >= first_level:
        if level == tree.depth:
            value, more = minimum_below(problem.pursuit, n, level, least, levels, scratch)
            interceptions += more
            if value < least:
                least = value
                _copy_sequence(n, level, levels, scratch.sequence, sequence)
            level -= 1
            continue
        rank = levels.counters[level, CHILD]
        if rank == n - level:
            level -= 1
            continue
        levels.counters[level, CHILD] += 1
        interceptions += 1
        time = earliest_at(problem.pursuit, n, level, rank, levels)
        if levels.disks[level, TIME] + time < least:
            capture_at(problem.pursuit, tree, n, level, rank, time, levels)
            level += 1
            enter(problem, tree, level, levels)
    return least, interceptions


@inlined
def _copy_sequence(n: int, level: int, levels: Levels, ranks: Ints, sequence: Ints) -> None:
    """Write the captures on the branch, and those of a node's evaders by their ranks."""
    for k in range(level):
        sequence[k] = levels.sequence[k]
    for k in range(n - level):
        sequence[level + k] = levels.numbers[level, ranks[k]]


@inlined
def enter_root(problem: Problem, levels: Levels) -> None:
    """Write the state of the game before any capture."""
    pursuit, disk = problem.pursuit, levels.disks[0]
    disk[CENTER_X], disk[CENTER_Y] = pursuit.center_x, pursuit.center_y
    disk[RADIUS], disk[TIME] = pursuit.first_radius, 0.0
    levels.counters[0, OFFSET] = 0
    for i in range(len(problem.evaders)):
        levels.numbers[0, i] = i
        for c in range(EVADER):
            levels.evaders[i, c] = problem.evaders[i, c]


@compiled
def enter(problem: Problem, tree: Tree, level: int, levels: Levels) -> None:
    """Write the paths of the evaders of a node."""
    n, offset = len(problem.evaders), levels.counters[level, OFFSET]
    first, count = level * n, n - level
    set_paths(
        levels.evaders[first : first + count],
        tree.turns[offset : offset + count],
        problem.pursuit.speed,
        levels.paths[first : first + count],
    )
    levels.counters[level, CHILD] = 0


@compiled
def minimum_below(
    pursuit: Pursuit, n: int, level: int, bound: float, levels: Levels, scratch: InnerScratch
) -> tuple[float, int]:
    """Return the least last capture where a node's evaders fly on whatever happens, if < `bound`.

    The sequence of their ranks that attains the minimum is written to `scratch.sequence`. Returns
    also the interceptions.
    """
    disk, paths = levels.disks[level], levels.paths[level * n : level * n + n - level]
    rest = Pursuit(
        disk[CENTER_X], disk[CENTER_Y], disk[RADIUS], pursuit.later_radius, pursuit.speed
    )
    sequence, left = scratch.sequence[: n - level], bound - disk[TIME]
    value, interceptions = inner_minimum(paths, rest, False, left, sequence, scratch)
    # Without a sequence below, the sum may be below the bound by rounding.
    least = min(disk[TIME] + value, bound) if value < left else bound
    return least, interceptions


@inlined
def earliest_at(pursuit: Pursuit, n: int, level: int, rank: int, levels: Levels) -> float:
    """Return the earliest capture of an evader of a node, in the time since the last capture."""
    disk = levels.disks[level]
    growing = GrowingDisk(disk[CENTER_X], disk[CENTER_Y], disk[RADIUS], 0.0, pursuit.speed)
    return earliest_capture(levels.paths, level * n + rank, growing)


@compiled
def capture_at(
    pursuit: Pursuit, tree: Tree, n: int, level: int, rank: int, time: float, levels: Levels
) -> None:
    """Write the state of the node after the capture of an evader at a time since the last one."""
    first, after = level * n, (level + 1) * n
    offset, below = levels.counters[level, OFFSET], levels.disks[level + 1]
    levels.sequence[level] = levels.numbers[level, rank]
    below[CENTER_X], below[CENTER_Y] = position(levels.paths, first + rank, time)
    below[RADIUS], below[TIME] = pursuit.later_radius, levels.disks[level, TIME] + time
    levels.counters[level + 1, OFFSET] = subtree(tree, n, level, offset, rank)
    k = 0
    for j in range(n - level):
        if j != rank:
            levels.numbers[level + 1, k] = levels.numbers[level, j]
            for c in range(EVADER):
                levels.evaders[after + k, c] = levels.evaders[first + j, c]
            turn = tree.turns[offset + j]
            move_on(levels.paths, first + j, turn, time, levels.evaders[after + k])
            k += 1
