"""By when an evader must have been captured if others are to follow before a bound.

The dynamic programme over subsets run backwards, for all evaders of a set at once, as far as sets
of a few; a larger set has the earliest deadline of the small ones in it. Few labels of the forward
programme keep their deadlines: one in four for eight evaders, one in twenty for twelve.
"""

from __future__ import annotations

import math

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Pursuit, Table
from covey.kernels.capture.path import START_X, START_Y, position
from covey.kernels.capture.straight_legs import latest_departures, padded

# Deadlines are later than need be at each capture, by this much of the bound and of the time that
# the coordinates take to fly, so that rounding drops nothing.
_SLACK = 1e-13


def new_deadlines(n: int) -> Table:
    """Allocate the table of deadlines of up to n evaders."""
    return np.empty((1 << n, padded(n)))


make_deadlines = allocating(new_deadlines)


@compiled
def set_deadlines(
    paths: Table,
    lines: Table,
    n: int,
    pursuit: Pursuit,
    bound: float,
    begin: int,
    end: int,
    deadlines: Table,
) -> None:
    """Write, to row S and column j, until when j must be captured if the set S is still ahead.

    All captures are to happen before `bound`. A deadline is never too early; one in the middle of a
    turn may be as late as the turn's end. -inf: it is too late for S at any time. The sets from
    `begin` to `end` are served, from 0 to 2^n in all; those in them have been served before.

    Evaders that are skipped in a large set would each grant the pursuer 2ρ, so every flight is
    granted 2ρ times n.
    """
    largest = 2 if n < 6 else (3 if n < 13 else 4)
    granted = n * pursuit.later_radius
    farthest = 0.0
    for i in range(n):
        farthest = max(farthest, abs(paths[i, START_X]), abs(paths[i, START_Y]))
    slack = _SLACK * (bound + farthest / pursuit.speed)
    if begin == 0:
        for j in range(padded(n)):
            deadlines[0, j] = bound + slack
    for ahead in range(max(begin, 1), end):
        if _is_larger(ahead, largest):
            _inherit(deadlines, n, ahead, largest)
            continue
        for j in range(padded(n)):
            deadlines[ahead, j] = -math.inf
        for i in range(n):
            if ahead >> i & 1:
                deadline = deadlines[ahead ^ 1 << i, i]
                if deadline >= 0.0:
                    x, y = position(paths, i, deadline)
                    latest_departures(
                        lines,
                        n,
                        x,
                        y,
                        granted,
                        deadline,
                        pursuit.speed,
                        slack,
                        deadlines[ahead],
                    )


@inlined
def _is_larger(members: int, size: int) -> bool:
    """Whether a set has more than `size` members."""
    for _ in range(size):
        members &= members - 1
    return members != 0


@inlined
def _inherit(deadlines: Table, n: int, ahead: int, largest: int) -> None:
    """Write the earliest deadlines of the sets without one member.

    Whatever few evaders one thinks of, one of the first `largest` + 1 members isn't among them.
    All at once: a loop over them would go through memory each time, and not in vector registers.
    """
    all_but_1 = ahead & (ahead - 1)
    all_but_2 = all_but_1 & (all_but_1 - 1)
    all_but_3 = all_but_2 & (all_but_2 - 1)
    all_but_4 = all_but_3 & (all_but_3 - 1)
    all_but_5 = all_but_4 & (all_but_4 - 1)
    second = ahead ^ all_but_1 ^ all_but_2
    third = ahead ^ all_but_2 ^ all_but_3
    fourth = ahead ^ all_but_3 ^ all_but_4 if largest > 2 else third
    fifth = ahead ^ all_but_4 ^ all_but_5 if largest > 3 else third
    for j in range(padded(n)):
        a, b, c = deadlines[all_but_1, j], deadlines[second, j], deadlines[third, j]
        d, e = deadlines[fourth, j], deadlines[fifth, j]
        a = a if a < b else b
        c = c if c < d else d
        a = a if a < c else c
        deadlines[ahead, j] = a if a < e else e
