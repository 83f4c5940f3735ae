"""The exact programme, without a table of all sets: few labels keep the deadlines of `completions`.

As in `last_capture`, the earliest arrival for each (captured set, last captured) is enough. Labels
of sets of one size are looked up in a hash table.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import MOST_EVADERS, Floats, Int32s, Ints, padded
from covey.kernels.capture.interception import capture_in_turn
from covey.kernels.capture.path import TURN_END
from covey.kernels.capture.pursuit import Pursuit, disk_after
from covey.kernels.capture.straight_legs import captures_on_lines
from covey.kernels.minimum.large.neighbours import memory_of
from covey.kernels.minimum.large.scratch import STATES, UPPER, LargeScratch, is_to_end, slot_of
from covey.kernels.minimum.large.walks import earliest_in_turn

FAILED = -1.0
_FULL = -1

_SET = (1 << MOST_EVADERS) - 1
# A product of 30 and 32 bits doesn't overflow.
_LOW_BITS = 30
_LOW = (1 << _LOW_BITS) - 1
_MIX_LOW, _MIX_HIGH = 0x9E3779B1, 0x85EBCA77
_SMALLEST = 1 << 10  # slots of a hash table


class Layer(NamedTuple):
    """The labels of sets of one size."""

    begin: int
    end: int  # `_FULL` where there was no room for a label
    slots: int  # of their hash table


@compiled
def search_labels(
    paths: Floats, pursuit: Pursuit, weight: int, bits: int, budget: int, scratch: LargeScratch
) -> float:
    """Return the least time of a sequence that takes less than the upper bound, else that bound.

    Parameters
    ----------
    paths, pursuit, weight, bits
        As for `least_walk`.
    budget
        How many labels may be kept.
    scratch
        With deadlines from `set_completions`. The best sequence is modified in place where one is
        below the bound, and labels are.

    Returns
    -------
    float
        `FAILED` where there are more labels than the budget, or the call is to end.
    """
    n, size = len(paths), 1 << bits
    budget = min(budget, len(scratch.sets))
    begin, end = 0, _first_labels(n, weight, size, scratch)
    for _ in range(n - 1):
        layer = Layer(end, end, _smallest_table(end - begin, scratch.table))
        for slot in range(layer.slots):
            scratch.table[slot] = 0
        for label in range(begin, end):
            layer = _extend(paths, pursuit, bits, label, budget, layer, scratch)
            if layer.end == _FULL or is_to_end(scratch):
                return FAILED
        scratch.known[STATES] += float(end - begin)
        begin, end = layer.begin, layer.end
    return _best_of(n, begin, end, scratch)


@inlined
def _first_labels(n: int, weight: int, size: int, scratch: LargeScratch) -> int:
    """Label the sets of one evader; return how many there are."""
    count = 0
    for i in range(n):
        arrival = scratch.first[i]
        deadline = scratch.values[slot_of(n, size, weight, i)]
        if arrival < scratch.known[UPPER] and arrival <= deadline:
            scratch.sets[count] = i << MOST_EVADERS | 1 << i
            scratch.times[count], scratch.before[count] = arrival, -1
            count += 1
    return count


@inlined
def _smallest_table(count: int, table: Int32s) -> int:
    """Return how many slots a hash table has at first, if as many labels were in the last layer."""
    slots = _SMALLEST
    while slots < 2 * count:
        slots *= 2
    return min(slots, len(table))


@compiled
def _extend(
    paths: Floats,
    pursuit: Pursuit,
    bits: int,
    label: int,
    budget: int,
    layer: Layer,
    scratch: LargeScratch,
) -> Layer:
    """Extend a label by the capture of each remaining evader; return the next layer."""
    n, size, arrivals = len(paths), 1 << bits, scratch.arrivals
    captured, last = scratch.sets[label] & _SET, scratch.sets[label] >> MOST_EVADERS
    count, weight = _set_remaining(n, captured, scratch)
    end, slots = layer.end, layer.slots
    disk = disk_after(paths, last, scratch.times[label], pursuit)
    captures_on_lines(scratch.lines, disk, arrivals[: padded(n)])
    for k in range(count):
        j = scratch.remaining[k]
        begin = slot_of(n, size, weight, j)
        latest, arrival = scratch.values[begin], arrivals[j]
        if arrival < paths[j, TURN_END]:
            if earliest_in_turn(paths, j, disk) > latest:
                continue
            arrival = capture_in_turn(paths, j, disk)
        if arrival > latest or arrival >= scratch.known[UPPER]:
            continue
        if arrival > scratch.values[begin + memory_of(scratch.neighbours, j, captured)]:
            continue
        if end == budget:
            return Layer(layer.begin, _FULL, slots)
        key = j << MOST_EVADERS | captured | 1 << j
        end = _enter(key, arrival, label, end, slots, scratch)
        if 2 * (end - layer.begin) > slots and slots < len(scratch.table):
            slots = _double(layer.begin, end, slots, scratch)
    return Layer(layer.begin, end, slots)


@inlined
def _set_remaining(n: int, captured: int, scratch: LargeScratch) -> tuple[int, int]:
    """Write who is not in a set; return how many they are and their weight."""
    count, weight = 0, 0
    for i in range(n):
        if not captured >> i & 1:
            scratch.remaining[count] = i
            weight += scratch.weights[i]
            count += 1
    return count, weight


@inlined
def _enter(
    key: int, arrival: float, label: int, end: int, slots: int, scratch: LargeScratch
) -> int:
    """Enter a label unless there is an earlier label; return the end of the labels."""
    slot = _slot_of_key(key, slots, scratch.sets, scratch.table)
    entered = scratch.table[slot] - 1
    if entered < 0:
        entered, end = end, end + 1
        scratch.table[slot], scratch.sets[entered] = entered + 1, key
        scratch.times[entered] = math.inf
    if arrival < scratch.times[entered]:
        scratch.times[entered], scratch.before[entered] = arrival, label
    return end


@inlined
def _slot_of_key(key: int, slots: int, sets: Ints, table: Int32s) -> int:
    """Return the slot of a set and last captured, an empty slot where it has no label."""
    mixed = (key & _LOW) * _MIX_LOW ^ (key >> _LOW_BITS) * _MIX_HIGH
    slot = (mixed >> 16 ^ mixed >> 33) & (slots - 1)
    while table[slot] > 0 and sets[table[slot] - 1] != key:
        slot = (slot + 1) & (slots - 1)
    return slot


@compiled
def _double(begin: int, end: int, slots: int, scratch: LargeScratch) -> int:
    """Enter the labels of a layer into a table twice as large; return its slots."""
    slots *= 2
    for slot in range(slots):
        scratch.table[slot] = 0
    for label in range(begin, end):
        slot = _slot_of_key(scratch.sets[label], slots, scratch.sets, scratch.table)
        scratch.table[slot] = label + 1
    return slots


@inlined
def _best_of(n: int, begin: int, end: int, scratch: LargeScratch) -> float:
    """Write the sequence of the least label of the full set, return its time."""
    best, least = -1, scratch.known[UPPER]
    for label in range(begin, end):
        if scratch.times[label] < least:
            best, least = label, scratch.times[label]
    if best >= 0:
        for k in range(n - 1, -1, -1):
            scratch.sequence[k] = scratch.sets[best] >> MOST_EVADERS
            best = scratch.before[best]
    return least
