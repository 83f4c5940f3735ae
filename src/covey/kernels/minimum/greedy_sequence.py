"""A short capture sequence by greedy search: the upper bound with which the exact search begins."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import next_capture, retime

_FEWEST = 10  # below, improving the sequence takes longer than the search that it prunes


@compiled
def greedy_sequence(paths: Floats, pursuit: Pursuit, sequence: Ints, times: Floats) -> float:
    """Write a short sequence of n evaders and its capture times; return the last time.

    1. Nearest first: the next evader is the evader that can be captured soonest.
    2. From ten evaders on: the same from each first evader, and the best of these sequences.
    3. There, insertion moves: one evader after the other moves to where the last capture is
       earliest, until a round of moves gains nothing.
    """
    n = len(paths)
    if n < _FEWEST:
        return nearest_first(paths, pursuit, -1, sequence, times)
    best, least = 0, math.inf
    for first in range(n):
        time = nearest_first(paths, pursuit, first, sequence, times)
        if time < least:
            best, least = first, time
    least = nearest_first(paths, pursuit, best, sequence, times)
    before = math.inf
    while least < before:
        before = least
        for i in range(n):
            least = _reinsert(paths, pursuit, i, sequence, times)
    return least


@compiled
def nearest_first(
    paths: Floats, pursuit: Pursuit, first: int, sequence: Ints, times: Floats
) -> float:
    """As `greedy_sequence`, step 1 alone, with a given first evader; -1: the nearest."""
    captured, last, time = 0, -1, 0.0
    for k in range(len(paths)):
        nearest, soonest = max(first, 0), math.inf
        if k == 0 and first >= 0:
            soonest = next_capture(paths, pursuit, -1, 0.0, first)
        else:
            for i in range(len(paths)):
                if not captured >> i & 1:
                    arrival = next_capture(paths, pursuit, last, time, i)
                    if arrival < soonest:
                        nearest, soonest = i, arrival
        captured, last, time = captured | 1 << nearest, nearest, soonest
        sequence[k], times[k] = nearest, soonest
    return time


@compiled
def _reinsert(paths: Floats, pursuit: Pursuit, i: int, sequence: Ints, times: Floats) -> float:
    """Move evader i to where the last capture is earliest; return that time."""
    n = len(paths)
    least, old = times[n - 1], 0
    while sequence[old] != i:
        old += 1
    for k in range(old, n - 1):
        sequence[k] = sequence[k + 1]
    retime(paths, pursuit, old, sequence[: n - 1], times)
    best = old
    for slot in range(n):
        if slot != old:
            time = _last_capture_with(paths, pursuit, i, slot, sequence, times, least)
            if time < least:
                best, least = slot, time
    for k in range(n - 1, best, -1):
        sequence[k] = sequence[k - 1]
    sequence[best] = i
    return retime(paths, pursuit, best, sequence[:n], times)


@compiled
def _last_capture_with(
    paths: Floats,
    pursuit: Pursuit,
    i: int,
    slot: int,
    sequence: Ints,
    times: Floats,
    bound: float,
) -> float:
    """Return the last capture if i is inserted into the sequence of the others; or >= `bound`."""
    last, time = -1, 0.0
    if slot > 0:
        last, time = sequence[slot - 1], times[slot - 1]
    time = next_capture(paths, pursuit, last, time, i)
    last = i
    for k in range(slot, len(paths) - 1):
        if time >= bound:
            break
        time = next_capture(paths, pursuit, last, time, sequence[k])
        last = sequence[k]
    return time
