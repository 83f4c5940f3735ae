"""The exact minimum over all capture sequences: dynamic programming over subsets (Held-Karp).

The pursuer is faster than every evader, so it can shadow one that it caught: being at a capture
earlier is never worse, and the earliest arrival for each (set of captured evaders, last captured)
is all that the rest of a sequence needs to know.
"""

from __future__ import annotations

import math

from covey.kernels._jit import allocating, compiled
from covey.kernels.arrays import Ints, Pursuit, Table
from covey.kernels.capture.straight_legs import make_lines, set_lines
from covey.kernels.minimum.deadlines import make_deadlines, set_deadlines
from covey.kernels.minimum.greedy_sequence import short_sequence
from covey.kernels.minimum.labels import (
    Labels,
    SubsetScratch,
    begin_labels,
    follow,
    forget,
    make_labels,
    trace_back,
)

MOST_EVADERS = 20
"""Largest team the exact minimum serves: its tables take 16 N 2^N bytes, 340 MB for N = 20."""

# Added to the time of a sequence, they make a bound that this sequence beats.
_SLACK, _LEAST = 1e-12, 1e-300


@allocating
def subset_scratch(n: int) -> SubsetScratch:
    """Allocate the scratch of `least_time`."""
    return SubsetScratch(make_labels(n), make_lines(n), make_deadlines(n))


@compiled
def least_time(
    paths: Table, n: int, pursuit: Pursuit, bound: float, sequence: Ints, scratch: SubsetScratch
) -> tuple[float, int]:
    """Least time of a capture sequence of all `n` evaders that is below `bound`, if there is one.

    Returns it and the number of interceptions computed, and writes its order to `sequence`; returns
    `bound` and leaves `sequence` alone where no sequence beats it. A finite bound, such as the time
    of a sequence that was the worst a moment ago, makes it many times faster.
    """
    labels, lines = scratch.labels, scratch.lines
    if bound == math.inf:
        bound = first_bound(paths, n, pursuit, sequence, labels)
    set_lines(paths, n, lines)
    set_deadlines(paths, lines, n, pursuit, bound, 0, 1 << n, scratch.deadlines)
    last_place = begin_labels(paths, n, pursuit, bound, scratch)
    interceptions, place = n, 1
    while place <= last_place and labels.queue[place] != (1 << n) - 1:
        last_place, cost = follow(
            paths,
            n,
            pursuit,
            bound,
            labels.queue[place],
            labels.times,
            place * n,
            last_place,
            scratch,
        )
        interceptions += cost
        place += 1
    least = trace_back(paths, n, pursuit, bound, sequence, labels, labels)
    forget(last_place, labels)
    return least, interceptions


@compiled
def first_bound(paths: Table, n: int, pursuit: Pursuit, sequence: Ints, labels: Labels) -> float:
    """A bound that a short sequence beats, which is written to `sequence`."""
    return short_sequence(paths, n, pursuit, sequence, labels.arrivals) * (1.0 + _SLACK) + _LEAST
