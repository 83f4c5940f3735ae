"""One branch of a contingent plan: Algorithm 1 where the evaders left turn anew at each capture.

Captures and evaders are numbered by their place in the capture sequence. Segment k of an evader is
its path between the k-th capture and the next; the last segment that a plan of depth d answers with
is segment d, which lasts until the evader's own capture.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, IntMatrix, Ints, IntVector, Matrix, Vector
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import (
    EVADER,
    HALF_RATE,
    HEADING,
    PATH,
    START_HEADING,
    STEERS,
    TURN_END,
    TURN_END_SLOPE,
    X,
    Y,
    position,
    set_paths,
    velocity,
)
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.contingent.tree import Tree, subtree
from covey.kernels.maximum.problem import Problem

# The end of a segment: position, velocity, rate of the heading (0 on the straight part), time flown
# straight (-1 while turning, or where the evader can't turn), slope of the end of the turn by it.
END_X, END_Y, SPEED_X, SPEED_Y, RATE, FLOWN, SLOPE = range(7)
SEGMENT = 7


class Branch(NamedTuple):
    """A branch of up to n captures, by their order."""

    times: Vector  # (n,) capture times
    evaders: Matrix  # (n, EVADER) where the present segment began
    turns: Vector  # (n,) of the present segment
    paths: Matrix  # (n, PATH) of the present segment
    segments: Matrix  # (n * n, SEGMENT) row j * n + k: segment k of the j-th captured evader
    variables: IntMatrix  # (n, n) entry (j, k): which turn of the tree segment k of evader j has


def new_branch(n: int) -> Branch:
    """Allocate a branch."""
    return Branch(
        np.empty(n),
        np.empty((n, EVADER)),
        np.empty(n),
        np.empty((n, PATH)),
        np.empty((n * n, SEGMENT)),
        np.empty((n, n), np.int64),
    )


@entry
def fly_branch(problem: Problem, tree: Tree, sequence: IntVector, branch: Branch) -> float:
    """Write the capture times of a sequence and the segments' ends; return the last time.

    Parameters
    ----------
    problem
        The evaders (n) and the pursuit; the objective is the last capture.
    tree
        Of n evaders.
    sequence
        (n,) the order of capture.
    branch
        Modified in place.
    """
    n, pursuit, times = len(sequence), problem.pursuit, branch.times
    for j in range(n):
        for c in range(EVADER):
            branch.evaders[j, c] = problem.evaders[sequence[j], c]
    x, y, radius = pursuit.center_x, pursuit.center_y, pursuit.first_radius
    now = began = 0.0  # of the last capture, of the segment
    offset = 0
    for k in range(n):
        if k <= tree.depth:
            if k > 0:
                rank = _rank(sequence, k - 1)
                offset = subtree(tree, n, k - 1, offset, rank)
                _end_segment(branch, n, k - 1, now - began)
                began = now
            _begin_segment(tree, sequence, k, offset, pursuit, branch)
        disk = GrowingDisk(x, y, radius, now - began, pursuit.speed)
        local = earliest_capture(branch.paths, k, disk)
        _set_end(branch, n, k, min(k, tree.depth), local)
        now, radius = began + local, pursuit.later_radius
        x, y = position(branch.paths, k, local)
        times[k] = now
    return now


@inlined
def _rank(sequence: Ints, k: int) -> int:
    """Return the rank of the k-th captured evader among those who lived until then."""
    rank = 0
    for j in range(k + 1, len(sequence)):
        rank += sequence[j] < sequence[k]
    return rank


@compiled
def _begin_segment(
    tree: Tree, sequence: Ints, k: int, offset: int, pursuit: Pursuit, branch: Branch
) -> None:
    """Write the turns and paths of segment k of all evaders that are left."""
    n = len(sequence)
    for j in range(k, n):
        rank = 0
        for other in range(k, n):
            rank += sequence[other] < sequence[j]
        branch.variables[j, k] = offset + rank
        branch.turns[j] = tree.turns[offset + rank]
    set_paths(branch.evaders[k:n], branch.turns[k:n], pursuit.speed, branch.paths[k:n])


@compiled
def _end_segment(branch: Branch, n: int, k: int, duration: float) -> None:
    """Write where segment k ends for all evaders that are left, and move them there."""
    for j in range(k + 1, n):
        _set_end(branch, n, j, k, duration)
        move_on(branch.paths, j, branch.turns[j], duration, branch.evaders[j])


@inlined
def move_on(paths: Floats, i: int, turn: float, duration: float, evader: Floats) -> None:
    """Move an evader (EVADER,) along path i, which makes a turn."""
    evader[X], evader[Y] = position(paths, i, duration)
    if duration < paths[i, TURN_END]:
        turn = 2.0 * paths[i, HALF_RATE] * duration
    evader[HEADING] = paths[i, START_HEADING] + turn * paths[i, STEERS]


@inlined
def _set_end(branch: Branch, n: int, j: int, k: int, duration: float) -> None:
    """Write the end of segment k of the j-th captured evader."""
    paths, row = branch.paths, branch.segments[j * n + k]
    row[END_X], row[END_Y] = position(paths, j, duration)
    row[SPEED_X], row[SPEED_Y] = velocity(paths, j, duration)
    row[RATE], row[FLOWN], row[SLOPE] = 0.0, -1.0, 0.0
    if duration < paths[j, TURN_END]:
        row[RATE] = 2.0 * paths[j, HALF_RATE]
    elif paths[j, STEERS] > 0.0:
        row[FLOWN], row[SLOPE] = duration - paths[j, TURN_END], paths[j, TURN_END_SLOPE]
