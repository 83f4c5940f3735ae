"""What a contingent plan guarantees if the pursuer may put captures off: a certified search.

A capture that is put off meets the team elsewhere, so the earliest capture need not be the worst.
The search covers all times of each answered capture by intervals. The capture in the middle of an
interval stands for all: with the same times between later captures, no evader is farther from its
place in the true play than a drift e. So the true play is one that a pursuer with radii larger by
2 e can have after the middle, and it begins no earlier than the interval. Intervals shrink until
every such bound is above the target.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import GO_ON, IntVector, Matrix, Workspace
from covey.kernels.capture.path import HALF_RATE, TURN_END, velocity
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.contingent.minimum import (
    CHILD,
    RADIUS,
    TIME,
    Levels,
    capture_at,
    earliest_at,
    enter,
    enter_root,
    minimum_from,
)
from covey.kernels.contingent.tree import Tree
from covey.kernels.maximum.problem import Problem
from covey.kernels.minimum.inner_minimum import InnerScratch, inner_scratch

_COARSE = 0.5  # an interval isn't halved any more where its drift is below this share of all drift


VISITED, MOST, PUT_OFF = range(3)  # counters

# The interval of capture times at a level: where it begins, its length, the drift on the way to the
# node, the drift that the interval adds.
_BEGIN, _LENGTH, _DRIFT, _ADDED = range(4)
INTERVAL = 4

_ROUNDING = 1e-12  # a shorter interval, relative to the target, may be lost in rounding


class DelaySearch(NamedTuple):
    """What a search is for, and its memory."""

    target: float  # the time after which every play is to end
    finest: float  # drift of the shortest intervals of the first capture, a length
    levels: Levels
    intervals: Matrix  # (n, INTERVAL) of each level, see above
    worst: IntVector  # (n,) of the play that may end before the target; modified in place
    counters: IntVector  # (3,) nodes visited; the most that may be; captures put off in that play


@entry
def survives_delays(
    problem: Problem, tree: Tree, search: DelaySearch, workspace: Workspace
) -> bool:
    """Return whether every play, with captures as late as the pursuer likes, ends after the target.

    The answer is no, too, where that can't be shown with intervals above the finest, or with the
    most nodes, or where `workspace.stop` was set. Then a play that may end before is left behind:
    its sequence in `search.worst`, and the times of the captures that are put off in
    `search.levels.disks`, from the second row on.

    Parameters
    ----------
    problem
        The evaders (n) and the pursuit; the objective is the last capture.
    tree
        Of n evaders.
    search
        Arrays for n evaders; modified in place.
    workspace
        With room for n evaders; modified in place.
    """
    scratch, level = inner_scratch(workspace), 0
    search.counters[VISITED] = 0
    enter_root(problem, search.levels)
    _enter(problem, tree, 0, 0.0, search)
    search.counters[PUT_OFF] = 0
    if not _ends_late(problem, tree, 0, search, scratch):
        return False
    while level >= 0:
        if workspace.stop[0] != GO_ON:
            return False
        if level < tree.depth and _next_interval(problem, tree, level, search):
            _enter(problem, tree, level + 1, _drift_below(level, search), search)
            if _ends_late(problem, tree, level + 1, search, scratch):
                level += 1
                continue
            search.counters[PUT_OFF] = level + 1
            while level >= 0 and not _halve(level, search):
                level -= 1
            if level < 0:
                return False
        else:
            level -= 1
            if level >= 0:
                _advance(level, search)
    return True


@inlined
def _drift_below(level: int, search: DelaySearch) -> float:
    """Return the drift of the plays that the interval of a level stands for."""
    return search.intervals[level, _DRIFT] + search.intervals[level, _ADDED]


@compiled
def _enter(problem: Problem, tree: Tree, level: int, drift: float, search: DelaySearch) -> None:
    """Write the paths of a node, and an empty interval before its first evader."""
    enter(problem, tree, level, search.levels)
    search.counters[VISITED] += 1
    search.intervals[level, _BEGIN], search.intervals[level, _LENGTH] = math.inf, 0.0
    search.intervals[level, _DRIFT] = drift


@compiled
def _ends_late(
    problem: Problem, tree: Tree, level: int, search: DelaySearch, scratch: InnerScratch
) -> bool:
    """Return whether all plays from a node on end after the target, if nothing more is put off.

    Where no capture is answered any more, these are all plays that count: on given paths it is
    never worse to be early.
    """
    pursuit, levels = problem.pursuit, search.levels
    wider = Pursuit(
        pursuit.center_x,
        pursuit.center_y,
        pursuit.first_radius,
        pursuit.later_radius + 2.0 * search.intervals[level, _DRIFT],
        pursuit.speed,
    )
    problem = Problem(problem.evaders, wider, problem.objective)
    value, _ = minimum_from(problem, tree, level, search.target, search.worst, levels, scratch)
    levels.counters[level, CHILD] = 0
    return value >= search.target


@compiled
def _next_interval(problem: Problem, tree: Tree, level: int, search: DelaySearch) -> bool:
    """Write the node after a capture in the interval; go on to the next evader at the target.

    Returns False where there is no other evader: all plays from here on end after the target.
    """
    n, levels, interval = len(problem.evaders), search.levels, search.intervals[level]
    left, rank = search.target - levels.disks[level, TIME], levels.counters[level, CHILD]
    while interval[_BEGIN] >= left:
        if interval[_BEGIN] < math.inf:
            rank += 1
        if rank == n - level:
            return False
        interval[_BEGIN] = earliest_at(problem.pursuit, n, level, rank, levels)
        interval[_LENGTH] = left - interval[_BEGIN]
    levels.counters[level, CHILD] = rank
    begin, half = interval[_BEGIN], 0.5 * interval[_LENGTH]
    interval[_ADDED] = _drift(n, level, begin, half, left, levels)
    capture_at(problem.pursuit, tree, n, level, rank, begin + half, levels)
    levels.disks[level + 1, TIME] = levels.disks[level, TIME] + begin
    levels.disks[level + 1, RADIUS] += 2.0 * _drift_below(level, search)
    return True


@inlined
def _advance(level: int, search: DelaySearch) -> None:
    """Go on to the next interval, where all plays of the present one end after the target."""
    interval, left = search.intervals[level], search.target - search.levels.disks[level, TIME]
    interval[_BEGIN] += interval[_LENGTH]
    interval[_LENGTH] = min(2.0 * interval[_LENGTH], left - interval[_BEGIN])


@inlined
def _halve(level: int, search: DelaySearch) -> bool:
    """Halve the interval of a level; return False where it is too short for that."""
    interval = search.intervals[level]
    shortest = max(search.finest, _COARSE * interval[_DRIFT])
    is_short = interval[_ADDED] <= shortest or interval[_LENGTH] <= _ROUNDING * search.target
    if is_short or search.counters[VISITED] > search.counters[MOST]:
        return False
    interval[_LENGTH] *= 0.5
    return True


@inlined
def _drift(n: int, level: int, begin: float, half: float, left: float, levels: Levels) -> float:
    """Return how far evaders are displaced until the target if a capture moves by at most `half`.

    The capture is at `begin` or later, and the target is `left` after the last capture.
    """
    drift = 0.0
    for i in range(level * n, level * n + n - level):
        velocity_x, velocity_y = velocity(levels.paths, i, begin)
        speed = math.hypot(velocity_x, velocity_y)
        turning = min(half, max(levels.paths[i, TURN_END] - begin, 0.0))
        turned = min(2.0 * abs(levels.paths[i, HALF_RATE]) * turning, 2.0)
        drift = max(drift, speed * (half + turned * max(left - begin, 0.0)))
    return drift
