"""Until when a capture must have happened if all is to end before a bound.

The dynamic programme asks these tables whether a label can still lead to a sequence below a bound
that is known: from evader j, caught at time t, the pursuer must be able to catch any one and any
two of the others before the bound. That drops nine labels of ten for ten evaders.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.path import (
    CLOSING,
    LINE_X,
    LINE_Y,
    TURN_END,
    VELOCITY_X,
    VELOCITY_Y,
    position,
)
from covey.kernels.types import Ints, Pursuit, Table

# Deadlines are later than need be by this much of the bound, so that rounding drops nothing.
_SLACK = 1e-12


class Deadlines(NamedTuple):
    """Deadlines at each of up to n evaders, p = (n - 1) (n - 2) / 2 pairs of others."""

    single: Table  # (n, n) at j if a is still to be caught
    pairs: Table  # (n, p) at j if both of a pair are still to be caught, the earliest first
    members: Ints  # (n, p) the pair, as a bit mask


@allocating
def make_deadlines(n: int) -> Deadlines:
    """Allocate deadlines for up to n evaders."""
    pairs = (n - 1) * (n - 2) // 2
    return Deadlines(np.empty((n, n)), np.empty((n, pairs)), np.empty((n, pairs), np.int64))


@compiled
def set_deadlines(
    paths: Table, n: int, pursuit: Pursuit, bound: float, deadlines: Deadlines
) -> None:
    """Write the deadlines if all captures are to happen before `bound`.

    Evaders that are skipped here would each grant the pursuer 2ρ, so every flight is granted 2ρ
    times n.
    """
    granted = n * pursuit.later_radius
    latest = bound * (1.0 + _SLACK)
    single = deadlines.single
    for a in range(n):
        x, y = position(paths, a, latest)
        for j in range(n):
            single[j, a] = _latest_departure(paths, j, x, y, granted, latest, pursuit.speed)
    for j in range(n):
        count = 0
        for a in range(n):
            for b in range(a):
                if j not in (a, b):
                    deadline = max(
                        _deadline_through(paths, j, a, single[a, b], granted, pursuit.speed),
                        _deadline_through(paths, j, b, single[b, a], granted, pursuit.speed),
                    )
                    _insert(deadlines, j, count, deadline, 1 << a | 1 << b)
                    count += 1


@inlined
def _deadline_through(
    paths: Table, j: int, a: int, deadline: float, granted: float, pursuer_speed: float
) -> float:
    """Deadline at j if a is next and has a deadline itself; -inf if that is past at time 0."""
    if deadline < 0.0:
        return -math.inf
    x, y = position(paths, a, deadline)
    return _latest_departure(paths, j, x, y, granted, deadline, pursuer_speed)


@inlined
def _insert(deadlines: Deadlines, j: int, count: int, deadline: float, pair: int) -> None:
    """Insert a pair among the `count` that j has, in the order of their deadlines."""
    k = count
    while k > 0 and deadlines.pairs[j, k - 1] > deadline:
        deadlines.pairs[j, k] = deadlines.pairs[j, k - 1]
        deadlines.members[j, k] = deadlines.members[j, k - 1]
        k -= 1
    deadlines.pairs[j, k] = deadline
    deadlines.members[j, k] = pair


@inlined
def too_late(deadlines: Deadlines, n: int, last: int, time: float, caught: int) -> bool:
    """Whether, from `last` caught at `time`, some pair that isn't in the set `caught` is lost."""
    for k in range((n - 1) * (n - 2) // 2):
        if deadlines.pairs[last, k] >= time:
            return False
        if not deadlines.members[last, k] & caught:
            return True
    return False


@inlined
def _latest_departure(
    paths: Table,
    j: int,
    x: float,
    y: float,
    granted: float,
    arrival: float,
    pursuer_speed: float,
) -> float:
    """No earlier than the latest time at evader j from which (x, y) is in reach at `arrival`.

    Root of |(x, y) - x_j(t)| = v_p (arrival - t) + granted, eq. (7) run backwards; where j is still
    turning then, the end of its turn.
    """
    velocity_x, velocity_y = paths[j, VELOCITY_X], paths[j, VELOCITY_Y]
    gap_x = x - paths[j, LINE_X] - velocity_x * arrival
    gap_y = y - paths[j, LINE_Y] - velocity_y * arrival
    outside = gap_x * gap_x + gap_y * gap_y - granted * granted
    departure = arrival
    if outside > 0.0:
        b = gap_x * velocity_x + gap_y * velocity_y - pursuer_speed * granted
        closing = paths[j, CLOSING]
        root = math.sqrt(b * b + outside * closing)
        departure -= (b + root if b > 0.0 else outside) / (closing if b > 0.0 else root - b)
    return max(departure, min(paths[j, TURN_END], arrival))
