"""Deadlines: by when an evader must be captured if others are to follow before a bound.

The dynamic programme over subsets runs backwards, for all evaders of a set at once, as far as small
sets. A larger set has the earliest deadline of the small sets in it. Few labels of the forward
programme keep their deadlines: one in four for eight evaders, one in twenty for twelve.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, padded
from covey.kernels.capture.path import START_X, START_Y, position
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.capture.straight_legs import latest_departures

# Deadlines are later than need be at each capture, by this much of the bound and of the time that
# the coordinates take to fly, so that rounding drops no label.
_SLACK = 1e-13


@compiled
def set_deadlines(
    paths: Floats, lines: Floats, pursuit: Pursuit, bound: float, deadlines: Floats
) -> None:
    """Write until when each evader must be captured, for each set that is still to follow.

    1. The empty set: the bound itself.
    2. Small sets: for each member, that is captured next, the latest departure which reaches the
       member by its own deadline; of these the latest.
    3. Larger sets inherit the earliest deadline of their small subsets.

    A deadline is never too early. A deadline in the middle of a turn may be as late as the turn's
    end. Evaders that are skipped in a large set would each grant the pursuer 2ρ, so every flight is
    granted 2ρ times n.

    Parameters
    ----------
    paths
        (n, PATH).
    lines
        (6, padded(n)) or more columns, see `set_lines`.
    pursuit
        The pursuer.
    bound
        All captures are to happen before this time.
    deadlines
        (2**n, padded(n)) by set and evader, times; -inf: too late for the set at any time. Modified
        in place.
    """
    n = len(paths)
    largest = 2 if n < 6 else (3 if n < 13 else 4)
    granted, slack = n * pursuit.later_radius, _slack(paths, pursuit, bound)
    for j in range(padded(n)):
        deadlines[0, j] = bound + slack
    for remaining in range(1, 1 << n):
        if _is_larger(remaining, largest):
            _inherit(deadlines, n, remaining, largest)
            continue
        for j in range(padded(n)):
            deadlines[remaining, j] = -math.inf
        for i in range(n):
            if remaining >> i & 1:
                deadline = deadlines[remaining ^ 1 << i, i]
                if deadline >= 0.0:
                    x, y = position(paths, i, deadline)
                    goal = GrowingDisk(x, y, granted, deadline, pursuit.speed)
                    latest_departures(lines, goal, slack, deadlines[remaining, : padded(n)])


@inlined
def _slack(paths: Floats, pursuit: Pursuit, bound: float) -> float:
    """Return by how much deadlines are later than need be."""
    farthest = 0.0
    for i in range(len(paths)):
        farthest = max(farthest, abs(paths[i, START_X]), abs(paths[i, START_Y]))
    return _SLACK * (bound + farthest / pursuit.speed)


@inlined
def _is_larger(members: int, size: int) -> bool:
    """Whether a set has more than `size` members."""
    for _ in range(size):
        members &= members - 1
    return members != 0


@inlined
def _inherit(deadlines: Floats, n: int, remaining: int, largest: int) -> None:
    """Write the earliest deadlines of the sets without one member.

    A subset of at most `largest` members misses one of the first `largest` + 1. So the minimum over
    leaving out each of these covers all such subsets. The minimum is taken in one pass over memory,
    in vector registers.
    """
    all_but_1 = remaining & (remaining - 1)
    all_but_2 = all_but_1 & (all_but_1 - 1)
    all_but_3 = all_but_2 & (all_but_2 - 1)
    all_but_4 = all_but_3 & (all_but_3 - 1)
    all_but_5 = all_but_4 & (all_but_4 - 1)
    second = remaining ^ all_but_1 ^ all_but_2
    third = remaining ^ all_but_2 ^ all_but_3
    fourth = remaining ^ all_but_3 ^ all_but_4 if largest > 2 else third
    fifth = remaining ^ all_but_4 ^ all_but_5 if largest > 3 else third
    for j in range(padded(n)):
        a, b, c = deadlines[all_but_1, j], deadlines[second, j], deadlines[third, j]
        d, e = deadlines[fourth, j], deadlines[fifth, j]
        a = a if a < b else b
        c = c if c < d else d
        a = a if a < c else c
        deadlines[remaining, j] = a if a < e else e
