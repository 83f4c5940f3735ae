"""The exact minimum over all capture sequences: dynamic programming over subsets (Held-Karp).

The pursuer is faster than every evader, so it can shadow one that it caught: being at a capture
earlier is never worse, and the earliest arrival for each (set of captured evaders, last captured)
is all that the rest of a sequence needs to know.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import allocating, compiled
from covey.kernels.deadlines import Deadlines, make_deadlines, set_deadlines, too_late
from covey.kernels.interception import earliest_capture
from covey.kernels.path import position
from covey.kernels.types import Floats, Ints, Pursuit, Table

MOST_EVADERS = 18
"""Largest team the exact minimum serves: its labels fill 8 N 2^N bytes, 38 MB for N = 18."""


class SubsetScratch(NamedTuple):
    """Arrays of the dynamic programme for up to n evaders; sets are bit masks."""

    labels: Floats  # (2**n * n,) earliest arrival by set and last captured; inf between calls
    reached: npt.NDArray[np.bool_]  # (2**n,) whether a set has a label; False between calls
    queue: Ints  # (2**n,) sets that have one, the smaller ones first
    ahead: Ints  # (n,) who is not yet captured
    deadlines: Deadlines


@allocating
def subset_scratch(n: int) -> SubsetScratch:
    """Allocate the scratch of `least_time`."""
    return SubsetScratch(
        np.full(n << n, math.inf),
        np.zeros(1 << n, np.bool_),
        np.empty(1 << n, np.int64),
        np.empty(n, np.int64),
        make_deadlines(n),
    )


@compiled
def least_time(
    paths: Table, n: int, pursuit: Pursuit, bound: float, sequence: Ints, scratch: SubsetScratch
) -> tuple[float, int]:
    """Least time of a capture sequence of all `n` evaders that is below `bound`, if there is one.

    Returns it and the number of interceptions computed, and writes its order to `sequence`; returns
    `bound` and leaves `sequence` alone where no sequence beats it. A finite bound, such as the time
    of a sequence that was the worst a moment ago, makes it many times faster.
    """
    labels, queue, ahead = scratch.labels, scratch.queue, scratch.ahead
    bounded = bound < math.inf
    interceptions = n
    if bounded:
        set_deadlines(paths, n, pursuit, bound, scratch.deadlines)
        interceptions += n * (n - 1) * (n - 1)
    full = (1 << n) - 1
    for i in range(n):
        queue[i] = 1 << i
        scratch.reached[1 << i] = True
        labels[(1 << i) * n + i] = earliest_capture(
            paths, i, pursuit.center_x, pursuit.center_y, pursuit.first_radius, 0.0, pursuit.speed
        )
    done, waiting = 0, n
    while done < waiting and queue[done] != full:
        caught = queue[done]
        done += 1
        count = 0
        for i in range(n):
            if not caught >> i & 1:
                ahead[count] = i
                count += 1
        for last in range(n):
            time = labels[caught * n + last]
            if time == math.inf:
                continue
            if bounded and too_late(scratch.deadlines, n, last, time, caught):
                continue
            x, y = position(paths, last, time)
            interceptions += count
            for k in range(count):
                i = ahead[k]
                arrival = earliest_capture(
                    paths, i, x, y, pursuit.later_radius, time, pursuit.speed
                )
                if arrival >= bound:
                    continue
                larger = caught | 1 << i
                if arrival < labels[larger * n + i]:
                    labels[larger * n + i] = arrival
                if not scratch.reached[larger]:
                    scratch.reached[larger] = True
                    queue[waiting] = larger
                    waiting += 1

    best, last = bound, -1
    for i in range(n):
        if labels[full * n + i] < best:
            best, last = labels[full * n + i], i
    if last >= 0:
        _trace_back(paths, n, pursuit, labels, last, sequence)
    for k in range(waiting):
        scratch.reached[queue[k]] = False
        for i in range(n):
            labels[queue[k] * n + i] = math.inf
    return best, interceptions


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
