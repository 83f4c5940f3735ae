"""The labels of the dynamic programme over subsets: earliest arrivals by (captured set, last).

Only sets that are reached get a slot, so little memory is touched, however many sets there are.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Int32s, Ints, Workspace, floats, ints, padded, padded_rows
from covey.kernels.capture.interception import capture_in_turn, earliest_capture
from covey.kernels.capture.path import TURN_END
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit, disk_after, initial_disk
from covey.kernels.capture.straight_legs import LINES, captures_on_lines


class Labels(NamedTuple):
    """Sets of up to n evaders, as bit masks, with their labels; and scratch of their extension."""

    slots: Int32s  # (2**n,) slot of each set that has a label, from 1; 0 between calls
    queue: Ints  # (2**n,) the sets by slot, smaller sets first
    times: Floats  # (2**n * n,) the labels by slot and last captured; inf: no label
    remaining: Ints  # (n + 1,) who is not yet captured
    arrivals: Floats  # (padded(n),) when the pursuer reaches each evader from one label


class SubsetScratch(NamedTuple):
    """Arrays of the dynamic programme for up to n evaders."""

    labels: Labels
    lines: Floats  # (6, padded(n))
    deadlines: Floats  # (2**n, padded(n)) by the set that is still to follow, and last captured
    stop: Ints  # (1,) of the workspace


@inlined
def subset_scratch(workspace: Workspace, n: int) -> SubsetScratch:
    """Carve the scratch of the dynamic programme for up to n evaders."""
    return SubsetScratch(
        Labels(
            workspace.slots,
            ints(workspace, 1 << n),
            floats(workspace, n << n),
            ints(workspace, n + 1),
            floats(workspace, padded(n)),
        ),
        padded_rows(workspace, LINES),
        padded_rows(workspace, 1 << n),
        workspace.stop,
    )


@compiled
def initial_labels(paths: Floats, pursuit: Pursuit, bound: float, scratch: SubsetScratch) -> int:
    """Label the sets of one evader; return the last slot in use."""
    n, deadlines, disk = len(paths), scratch.deadlines, initial_disk(pursuit)
    arrivals, last_slot = scratch.labels.arrivals[: padded(n)], 0
    captures_on_lines(scratch.lines, disk, arrivals)
    for i in range(n):
        arrival = arrivals[i]
        if arrival < paths[i, TURN_END]:
            arrival = capture_in_turn(paths, i, disk)
        if arrival < bound and arrival <= deadlines[(1 << n) - 1 ^ 1 << i, i]:
            last_slot = _label(n, 1 << i, i, arrival, last_slot, scratch.labels)
    return last_slot


@inlined
def extend(
    paths: Floats, pursuit: Pursuit, bound: float, slot: int, last_slot: int, scratch: SubsetScratch
) -> tuple[int, int]:
    """Extend each label of the set in a slot by the capture of each remaining evader.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    bound
        Arrivals at this time or later get no label.
    slot
        Of the set whose labels are extended.
    last_slot
        The last slot in use.
    scratch
        Lines and deadlines of the paths; the labels are modified in place.

    Returns
    -------
    int
        The last slot in use.
    int
        How many interceptions were computed.
    """
    labels, n, captured = scratch.labels, len(paths), scratch.labels.queue[slot]
    count, interceptions = _set_remaining(n, captured, labels), 0
    arrivals = labels.arrivals[: padded(n)]
    for last in range(n):
        time = labels.times[slot * n + last]
        if time == math.inf:
            continue
        disk = disk_after(paths, last, time, pursuit)
        captures_on_lines(scratch.lines, disk, arrivals)
        interceptions += count
        last_slot = _extend_label(paths, bound, captured, count, disk, last_slot, scratch)
    return last_slot, interceptions


@inlined
def _set_remaining(n: int, captured: int, labels: Labels) -> int:
    """Write who is not in a set; return how many they are."""
    count = 0
    for i in range(n):
        labels.remaining[count] = i
        count += 1 - (captured >> i & 1)
    return count


@inlined
def _extend_label(
    paths: Floats,
    bound: float,
    captured: int,
    count: int,
    disk: GrowingDisk,
    last_slot: int,
    scratch: SubsetScratch,
) -> int:
    """Label the sets that one label leads to, from the arrivals on lines; return the last slot."""
    labels, deadlines, n = scratch.labels, scratch.deadlines, len(paths)
    full = (1 << n) - 1
    for k in range(count):
        i = labels.remaining[k]
        arrival = labels.arrivals[i]
        if arrival < paths[i, TURN_END]:
            arrival = capture_in_turn(paths, i, disk)
        larger = captured | 1 << i
        if arrival >= bound or arrival > deadlines[full ^ larger, i]:
            continue
        last_slot = _label(n, larger, i, arrival, last_slot, labels)
    return last_slot


@inlined
def _label(n: int, captured: int, last: int, arrival: float, last_slot: int, labels: Labels) -> int:
    """Label a set unless it has an earlier label; return the last slot in use."""
    slot = labels.slots[captured]
    if slot == 0:
        last_slot += 1
        slot = last_slot
        labels.slots[captured] = slot
        labels.queue[slot] = captured
        for i in range(n):
            labels.times[slot * n + i] = math.inf
    label = slot * n + last
    labels.times[label] = min(labels.times[label], arrival)
    return last_slot


@inlined
def label_of(n: int, captured: int, last: int, labels: Labels) -> float:
    """Return the label of a set and a last captured evader, inf if there is none."""
    slot = labels.slots[captured]
    return labels.times[slot * n + last] if slot > 0 else math.inf


@compiled
def trace_back(
    paths: Floats, pursuit: Pursuit, bound: float, sequence: Ints, labels: Labels
) -> float:
    """Write the sequence of the least label of the full set; return that label.

    Returns `bound`, and leaves the sequence alone, where no label is less.
    """
    n = len(paths)
    captured, target, last = (1 << n) - 1, bound, -1
    for i in range(n):
        time = label_of(n, captured, i, labels)
        if time < target:
            target, last = time, i
    if last < 0:
        return bound
    least = target
    sequence[n - 1] = last
    for k in range(n - 2, -1, -1):
        captured ^= 1 << last
        before, before_time, least_error = -1, math.inf, math.inf
        for i in range(n):
            time = label_of(n, captured, i, labels)
            if time < math.inf:
                arrival = earliest_capture(paths, last, disk_after(paths, i, time, pursuit))
                if abs(arrival - target) < least_error:
                    before, before_time, least_error = i, time, abs(arrival - target)
        last, target = before, before_time
        sequence[k] = last
    return least


@compiled
def clear(last_slot: int, labels: Labels) -> None:
    """Take the slot from each set."""
    for slot in range(1, last_slot + 1):
        labels.slots[labels.queue[slot]] = 0
