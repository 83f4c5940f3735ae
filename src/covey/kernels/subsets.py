"""The exact minimum over all capture sequences: dynamic programming over subsets (Held-Karp).

The pursuer is faster than every evader, so it can shadow one that it caught: being at a capture
earlier is never worse, and the earliest arrival for each (set of captured evaders, last captured)
is all that the rest of a sequence needs to know.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.interception import earliest_capture
from covey.kernels.path import position
from covey.kernels.types import Floats, Ints, Pursuit, Table

MOST_EVADERS = 18
"""Largest team the exact minimum serves: its labels fill 8 * N * 2**N bytes, 38 MB for N = 18."""


@compiled
def least_time(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    bound: float,
    labels: Floats,
    arrivals: Floats,
    members: Ints,
    sequence: Ints,
) -> tuple[float, int]:
    """Least time of a capture sequence of all `n` evaders that is below `bound`, if there is one.

    Returns it and the number of interceptions computed, and writes its order to `sequence`; returns
    `bound` and leaves `sequence` alone where no sequence beats it. `labels` (2**n * n at least),
    `arrivals` (n) and `members` (n) are scratch. A label from which some evader is out of reach
    before `bound` is dropped.
    """
    full = (1 << n) - 1
    for label in range(n << n):
        labels[label] = math.inf
    interceptions = n
    for i in range(n):
        labels[(1 << i) * n + i] = earliest_capture(
            paths, i, pursuit.center_x, pursuit.center_y, pursuit.first_radius, 0.0, pursuit.speed
        )
    for caught in range(1, full):
        ahead, behind = 0, n
        for i in range(n):
            if caught >> i & 1:
                behind -= 1
                members[behind] = i
            else:
                members[ahead] = i
                ahead += 1
        for k in range(behind, n):
            last = members[k]
            time = labels[caught * n + last]
            if time >= bound:
                continue
            x, y = position(paths, last, time)
            reached = _reach(paths, members, ahead, x, y, time, pursuit, bound, arrivals)
            interceptions += min(reached + 1, ahead)
            if reached < ahead:
                continue
            for a in range(ahead):
                i = members[a]
                label = (caught | 1 << i) * n + i
                labels[label] = min(labels[label], arrivals[a])

    best, last = bound, -1
    for i in range(n):
        if labels[full * n + i] < best:
            best, last = labels[full * n + i], i
    if last >= 0:
        _trace_back(paths, n, pursuit, labels, last, sequence)
    return best, interceptions


@inlined
def _reach(
    paths: Table,
    targets: Ints,
    count: int,
    x: float,
    y: float,
    time: float,
    pursuit: Pursuit,
    bound: float,
    arrivals: Floats,
) -> int:
    """Write the arrivals at the first `count` targets; stop at one that can't be before `bound`.

    A detour over other evaders is longer, but each capture on the way grants another 2ρ. So an
    evader is out of reach only if it is with 2ρ for each capture that is still to come.
    """
    for k in range(count):
        arrivals[k] = earliest_capture(
            paths, targets[k], x, y, pursuit.later_radius, time, pursuit.speed
        )
        if arrivals[k] >= bound:
            granted = count * pursuit.later_radius
            if (
                granted == 0.0
                or earliest_capture(paths, targets[k], x, y, granted, time, pursuit.speed) >= bound
            ):
                return k
    return count


@compiled
def _trace_back(
    paths: Table, n: int, pursuit: Pursuit, labels: Floats, last: int, sequence: Ints
) -> None:
    """Write the sequence whose last label is that of `last` in the full set."""
    caught = (1 << n) - 1
    sequence[n - 1] = last
    for k in range(n - 2, -1, -1):
        target = labels[caught * n + last]
        caught ^= 1 << last
        before, least_error = -1, math.inf
        for i in range(n):
            time = labels[caught * n + i]
            if caught >> i & 1 and time < math.inf:
                x, y = position(paths, i, time)
                arrival = earliest_capture(
                    paths, last, x, y, pursuit.later_radius, time, pursuit.speed
                )
                if abs(arrival - target) < least_error:
                    before, least_error = i, abs(arrival - target)
        last = before
        sequence[k] = last
