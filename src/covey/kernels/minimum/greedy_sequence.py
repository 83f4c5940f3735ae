"""A short capture sequence, found in no time: the bound with which the exact search starts."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import position

_FEWEST = 10  # below, looking for a shorter sequence takes longer than the search that it prunes


@compiled
def short_sequence(paths: Table, n: int, pursuit: Pursuit, sequence: Ints, times: Floats) -> float:
    """Write a short sequence of n evaders and its capture times; return the last of them.

    Whoever can be captured soonest is next. With many evaders, this after each that may be the
    first; in the best of these sequences evaders then move to where they cost least, one after
    the other, for as long as this gains.
    """
    if n < _FEWEST:
        return nearest_first(paths, n, pursuit, -1, sequence, times)
    best, least = 0, math.inf
    for first in range(n):
        time = nearest_first(paths, n, pursuit, first, sequence, times)
        if time < least:
            best, least = first, time
    least = nearest_first(paths, n, pursuit, best, sequence, times)
    before = math.inf
    while least < before:
        before = least
        for i in range(n):
            least = _move(paths, n, pursuit, i, sequence, times)
    return least


@compiled
def nearest_first(
    paths: Table, n: int, pursuit: Pursuit, first: int, sequence: Ints, times: Floats
) -> float:
    """As `short_sequence`: whoever can be captured soonest is next, from the `first` on.

    Where that is -1, the first one too is whoever can be captured soonest.
    """
    caught, last, time = 0, -1, 0.0
    for k in range(n):
        nearest, soonest = max(first, 0), math.inf
        if k == 0 and first >= 0:
            soonest = _next_capture(paths, pursuit, -1, 0.0, first)
        else:
            for i in range(n):
                if not caught >> i & 1:
                    arrival = _next_capture(paths, pursuit, last, time, i)
                    if arrival < soonest:
                        nearest, soonest = i, arrival
        caught, last, time = caught | 1 << nearest, nearest, soonest
        sequence[k], times[k] = nearest, soonest
    return time


@inlined
def _next_capture(paths: Table, pursuit: Pursuit, last: int, time: float, i: int) -> float:
    """When i is captured after `last` was at a `time`, or as the first where that is -1."""
    x, y, radius = pursuit.center_x, pursuit.center_y, pursuit.first_radius
    if last >= 0:
        x, y = position(paths, last, time)
        radius = pursuit.later_radius
    return earliest_capture(paths, i, x, y, radius, time, pursuit.speed)


@compiled
def _move(paths: Table, n: int, pursuit: Pursuit, i: int, sequence: Ints, times: Floats) -> float:
    """Move evader i to where the last capture is earliest; return that time."""
    least, old = times[n - 1], 0
    while sequence[old] != i:
        old += 1
    for k in range(old, n - 1):
        sequence[k] = sequence[k + 1]
    _fly(paths, n - 1, pursuit, old, sequence, times)
    best = old
    for place in range(n):
        if place != old:
            time = _last_capture(paths, n, pursuit, i, place, sequence, times, least)
            if time < least:
                best, least = place, time
    for k in range(n - 1, best, -1):
        sequence[k] = sequence[k - 1]
    sequence[best] = i
    return _fly(paths, n, pursuit, best, sequence, times)


@compiled
def _fly(
    paths: Table, n: int, pursuit: Pursuit, begin: int, sequence: Ints, times: Floats
) -> float:
    """Write the times of a sequence of n from its place `begin` on; return the last one."""
    last, time = -1, 0.0
    if begin > 0:
        last, time = sequence[begin - 1], times[begin - 1]
    for k in range(begin, n):
        time = _next_capture(paths, pursuit, last, time, sequence[k])
        last, times[k] = sequence[k], time
    return time


@compiled
def _last_capture(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    i: int,
    place: int,
    sequence: Ints,
    times: Floats,
    bound: float,
) -> float:
    """The last capture if i joins a sequence of the n - 1 others there; or a time >= `bound`."""
    last, time = -1, 0.0
    if place > 0:
        last, time = sequence[place - 1], times[place - 1]
    time = _next_capture(paths, pursuit, last, time, i)
    last = i
    for k in range(place, n - 1):
        if time >= bound:
            break
        time = _next_capture(paths, pursuit, last, time, sequence[k])
        last = sequence[k]
    return time
