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

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.deadlines import set_deadlines
from covey.kernels.interception import capture_in_turn, earliest_capture
from covey.kernels.lines import captures_on_lines, make_lines, padded, set_lines
from covey.kernels.path import TURN_END, position
from covey.kernels.short_sequence import short_sequence
from covey.kernels.types import Floats, Ints, Pursuit, Table

MOST_EVADERS = 18
"""Largest team the exact minimum serves: its tables fill 16 N 2^N bytes, 80 MB for N = 18."""


# Added to the time of a sequence, they make a bound that this sequence beats.
_SLACK, _LEAST = 1e-12, 1e-300


class SubsetScratch(NamedTuple):
    """Arrays of the dynamic programme for up to n evaders; sets are bit masks."""

    labels: Floats  # (2**n * n,) earliest arrival by place of the set and last captured
    places: npt.NDArray[np.int32]  # (2**n,) of the sets that have a label; 0 between calls
    queue: Ints  # (2**n,) the sets by place, the smaller ones first
    ahead: Ints  # (n,) who is not yet captured
    lines: Table
    arrivals: Floats  # (n,) when the pursuer reaches each evader from one label
    deadlines: Table  # (2**n, n) by the set that is still ahead, and last captured


@allocating
def subset_scratch(n: int) -> SubsetScratch:
    """Allocate the scratch of `least_time`."""
    return SubsetScratch(
        np.empty(n << n),
        np.zeros(1 << n, np.int32),
        np.empty(1 << n, np.int64),
        np.empty(n + 1, np.int64),
        make_lines(n),
        np.empty(padded(n)),
        np.empty((1 << n, padded(n))),
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
    queue, arrivals, deadlines = scratch.queue, scratch.arrivals, scratch.deadlines
    labels, places, ahead = scratch.labels, scratch.places, scratch.ahead
    full = (1 << n) - 1
    if bound == math.inf:
        bound = short_sequence(paths, n, pursuit, sequence, arrivals) * (1.0 + _SLACK) + _LEAST
    set_lines(paths, n, scratch.lines)
    set_deadlines(paths, scratch.lines, n, pursuit, bound, deadlines)
    x, y = pursuit.center_x, pursuit.center_y
    captures_on_lines(scratch.lines, n, x, y, pursuit.first_radius, 0.0, pursuit.speed, arrivals)
    interceptions, last_place = n, 0
    for i in range(n):
        arrival = arrivals[i]
        if arrival < paths[i, TURN_END]:
            arrival = capture_in_turn(paths, i, x, y, pursuit.first_radius, 0.0, pursuit.speed)
        if arrival < bound and arrival <= deadlines[full ^ 1 << i, i]:
            last_place += 1
            _enter(1 << i, last_place, n, scratch)
            labels[last_place * n + i] = arrival
    place = 1
    while place <= last_place and queue[place] != full:
        caught = queue[place]
        count = 0
        for i in range(n):
            ahead[count] = i
            count += 1 - (caught >> i & 1)
        for last in range(n):
            time = labels[place * n + last]
            if time == math.inf:
                continue
            x, y = position(paths, last, time)
            captures_on_lines(
                scratch.lines, n, x, y, pursuit.later_radius, time, pursuit.speed, arrivals
            )
            interceptions += count
            for k in range(count):
                i = ahead[k]
                arrival = arrivals[i]
                if arrival < paths[i, TURN_END]:
                    arrival = capture_in_turn(
                        paths, i, x, y, pursuit.later_radius, time, pursuit.speed
                    )
                larger = caught | 1 << i
                if arrival >= bound or arrival > deadlines[full ^ larger, i]:
                    continue
                if places[larger] == 0:
                    last_place += 1
                    _enter(larger, last_place, n, scratch)
                label = places[larger] * n + i
                labels[label] = min(labels[label], arrival)
        place += 1

    best, last = bound, -1
    if places[full] > 0:
        for i in range(n):
            if labels[places[full] * n + i] < best:
                best, last = labels[places[full] * n + i], i
    if last >= 0:
        _trace_back(paths, n, pursuit, last, sequence, scratch)
    for k in range(1, last_place + 1):
        places[queue[k]] = 0
    return best, interceptions


@inlined
def _enter(caught: int, place: int, n: int, scratch: SubsetScratch) -> None:
    """Give a set its place, where it has no labels yet."""
    scratch.places[caught] = place
    scratch.queue[place] = caught
    for i in range(n):
        scratch.labels[place * n + i] = math.inf


@compiled
def _trace_back(
    paths: Table, n: int, pursuit: Pursuit, last: int, sequence: Ints, scratch: SubsetScratch
) -> None:
    """Write the sequence whose last label is that of `last` in the full set."""
    caught = (1 << n) - 1
    sequence[n - 1] = last
    for k in range(n - 2, -1, -1):
        target = scratch.labels[scratch.places[caught] * n + last]
        caught ^= 1 << last
        place = scratch.places[caught]
        before, least_error = -1, math.inf
        for i in range(n):
            time = scratch.labels[place * n + i]
            if time < math.inf:
                x, y = position(paths, i, time)
                arrival = earliest_capture(
                    paths, last, x, y, pursuit.later_radius, time, pursuit.speed
                )
                if abs(arrival - target) < least_error:
                    before, least_error = i, abs(arrival - target)
        last = before
        sequence[k] = last
