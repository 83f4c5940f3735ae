"""The labels of the dynamic programme over subsets: earliest arrivals by (captured set, last).

Only sets that are reached have a place, so however many sets there are, little memory is touched.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.interception import capture_in_turn, earliest_capture
from covey.kernels.capture.path import TURN_END, position
from covey.kernels.capture.straight_legs import captures_on_lines, padded


class Labels(NamedTuple):
    """Sets, as bit masks, and their labels; and scratch of whoever follows them.

    Of n evaders there may be fewer.
    """

    places: npt.NDArray[np.int32]  # (2**n,) of the sets that have a label, from 1; 0 between calls
    queue: Ints  # (2**n,) the sets by place, the smaller ones first
    times: Floats  # (2**n * n,) the labels by place and last captured; inf: there is none
    ahead: Ints  # (n,) who is not yet captured
    arrivals: Floats  # (n,) when the pursuer reaches each evader from one label


def new_labels(n: int) -> Labels:
    """Allocate the labels of up to n evaders."""
    return Labels(
        np.zeros(1 << n, np.int32),
        np.empty(1 << n, np.int64),
        np.empty(n << n),
        np.empty(n + 1, np.int64),
        np.empty(padded(n)),
    )


make_labels = allocating(new_labels)


class SubsetScratch(NamedTuple):
    """Arrays of the dynamic programme for up to n evaders."""

    labels: Labels
    lines: Table
    deadlines: Table  # (2**n, n) by the set that is still ahead, and last captured


@compiled
def begin_labels(
    paths: Table, n: int, pursuit: Pursuit, bound: float, scratch: SubsetScratch
) -> int:
    """Label the sets of one evader; return the last place."""
    labels, deadlines = scratch.labels, scratch.deadlines
    x, y, arrivals = pursuit.center_x, pursuit.center_y, labels.arrivals
    captures_on_lines(scratch.lines, n, x, y, pursuit.first_radius, 0.0, pursuit.speed, arrivals)
    last_place = 0
    for i in range(n):
        arrival = arrivals[i]
        if arrival < paths[i, TURN_END]:
            arrival = capture_in_turn(paths, i, x, y, pursuit.first_radius, 0.0, pursuit.speed)
        if arrival < bound and arrival <= deadlines[(1 << n) - 1 ^ 1 << i, i]:
            last_place = _label(1 << i, i, arrival, n, last_place, labels)
    return last_place


@inlined
def follow(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    bound: float,
    caught: int,
    times: Floats,
    first: int,
    last_place: int,
    scratch: SubsetScratch,
) -> tuple[int, int]:
    """Capture another evader after each label of a set, which is in `times` from `first` on.

    Returns the last place, and how many interceptions were computed.
    """
    labels, lines, deadlines = scratch.labels, scratch.lines, scratch.deadlines
    ahead, arrivals = labels.ahead, labels.arrivals
    full = (1 << n) - 1
    interceptions = count = 0
    for i in range(n):
        ahead[count] = i
        count += 1 - (caught >> i & 1)
    for last in range(n):
        time = times[first + last]
        if time == math.inf:
            continue
        x, y = position(paths, last, time)
        captures_on_lines(lines, n, x, y, pursuit.later_radius, time, pursuit.speed, arrivals)
        interceptions += count
        for k in range(count):
            i = ahead[k]
            arrival = arrivals[i]
            if arrival < paths[i, TURN_END]:
                arrival = capture_in_turn(paths, i, x, y, pursuit.later_radius, time, pursuit.speed)
            larger = caught | 1 << i
            if arrival >= bound or arrival > deadlines[full ^ larger, i]:
                continue
            last_place = _label(larger, i, arrival, n, last_place, labels)
    return last_place, interceptions


@inlined
def _label(caught: int, last: int, arrival: float, n: int, last_place: int, labels: Labels) -> int:
    """Label a set unless it has an earlier label; return the last place."""
    place = labels.places[caught]
    if place == 0:
        last_place += 1
        place = last_place
        labels.places[caught] = place
        labels.queue[place] = caught
        for i in range(n):
            labels.times[place * n + i] = math.inf
    label = place * n + last
    labels.times[label] = min(labels.times[label], arrival)
    return last_place


@inlined
def label_of(caught: int, last: int, n: int, labels: Labels) -> float:
    """The label of a set, inf if it has none."""
    place = labels.places[caught]
    return labels.times[place * n + last] if place > 0 else math.inf


@compiled
def trace_back(
    paths: Table, n: int, pursuit: Pursuit, bound: float, sequence: Ints, one: Labels, other: Labels
) -> float:
    """Write the sequence of the least label of the full set, in either of two tables.

    Returns that label; `bound` where none is less.
    """
    caught, target, last = (1 << n) - 1, bound, -1
    for i in range(n):
        time = min(label_of(caught, i, n, one), label_of(caught, i, n, other))
        if time < target:
            target, last = time, i
    if last < 0:
        return bound
    least = target
    sequence[n - 1] = last
    for k in range(n - 2, -1, -1):
        caught ^= 1 << last
        before, before_time, least_error = -1, math.inf, math.inf
        for i in range(n):
            time = min(label_of(caught, i, n, one), label_of(caught, i, n, other))
            if time < math.inf:
                x, y = position(paths, i, time)
                arrival = earliest_capture(
                    paths, last, x, y, pursuit.later_radius, time, pursuit.speed
                )
                if abs(arrival - target) < least_error:
                    before, before_time, least_error = i, time, abs(arrival - target)
        last, target = before, before_time
        sequence[k] = last
    return least


@compiled
def forget(last_place: int, labels: Labels) -> None:
    """Leave no set a place."""
    for place in range(1, last_place + 1):
        labels.places[labels.queue[place]] = 0
