"""The least walk: a lower bound of all sequences.

Every evader has a weight, and a walk collects the weight of each evader that it captures, however
often. All sequences collect the sum of all weights, so the least walk that collects this sum takes
no longer than the least sequence. What a walk remembers is said in `neighbours`. An earlier arrival
is never worse, so the earliest arrival for each (weight, last captured, memory) is enough.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Int32s, Ints, padded
from covey.kernels.capture.interception import capture_in_turn
from covey.kernels.capture.path import START_X, START_Y, TURN_END, VELOCITY_X, VELOCITY_Y
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit, disk_after
from covey.kernels.capture.straight_legs import captures_on_lines
from covey.kernels.minimum.large.neighbours import FORBIDDEN
from covey.kernels.minimum.large.scratch import STATES, UPPER, LargeScratch, State, slot_of

_ROUNDING = 1e-14


@compiled
def least_walk(
    paths: Floats, pursuit: Pursuit, weight: int, bits: int, scratch: LargeScratch
) -> tuple[float, int]:
    """Return the time of the least walk, and the state that it ends in.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    weight
        That walks collect: the sum of `scratch.weights`.
    bits
        Of a memory.
    scratch
        With weights, transitions, first captures, and the upper bound of interest. The earliest
        arrivals and how they came about are modified in place.

    Returns
    -------
    float
        inf, where each walk takes as long as the upper bound.
    int
        Last evader and memory: i * 2**bits + memory.
    """
    n, size, values = len(paths), 1 << bits, scratch.values
    _begin(n, weight, size, scratch)
    for q in range(1, weight):
        for i in range(n):
            begin = slot_of(n, size, q, i)
            for memory in range(size):
                time = values[begin + memory]
                if is_undominated(memory, time, 1.0, bits, scratch.least) and (
                    time < scratch.known[UPPER]
                ):
                    scratch.known[STATES] += 1.0
                    _extend(paths, pursuit, State(i, memory, begin, weight - q), bits, scratch)
    least, end = math.inf, -1
    begin = slot_of(n, size, weight, 0)
    for state in range(n * size):
        if values[begin + state] < least:
            least, end = values[begin + state], state
    return least, end


@inlined
def _begin(n: int, weight: int, size: int, scratch: LargeScratch) -> None:
    """Write the walks of one capture."""
    values, steps = scratch.values, scratch.steps
    for slot in range(slot_of(n, size, weight + 1, 0)):
        values[slot] = math.inf
    for i in range(n):
        slot = slot_of(n, size, scratch.weights[i], i)
        values[slot], steps[slot] = scratch.first[i], -1


@inlined
def is_undominated(memory: int, time: float, sign: float, bits: int, least: Floats) -> bool:
    """Whether no memory in this memory arrives as early; write the earliest arrival to `least`.

    `sign`: 1 where early times are better, -1 where late times are.
    """
    earliest = math.inf
    for k in range(bits):
        if memory >> k & 1:
            earliest = min(earliest, least[memory ^ 1 << k])
    least[memory] = min(earliest, sign * time)
    return sign * time < earliest


@inlined
def _extend(
    paths: Floats, pursuit: Pursuit, state: State, bits: int, scratch: LargeScratch
) -> None:
    """Extend a state by each capture that its memory and the weight that is left allow."""
    n, size, arrivals = len(paths), 1 << bits, scratch.arrivals
    values, steps, transitions = scratch.values, scratch.steps, scratch.transitions
    i, memory, begin, left = state
    disk = disk_after(paths, i, values[begin + memory], pursuit)
    captures_on_lines(scratch.lines, disk, arrivals[: padded(n)])
    for j in range(n):
        after = transitions[(i * n + j) * size + memory]
        if after == FORBIDDEN or scratch.weights[j] > left:
            continue
        # The state's own weight is in its first slot.
        slot = begin + slot_of(n, size, scratch.weights[j], j - i) + after
        arrival = arrivals[j]
        if arrival < paths[j, TURN_END]:
            if earliest_in_turn(paths, j, disk) >= values[slot]:
                continue
            arrival = capture_in_turn(paths, j, disk)
        if arrival < values[slot]:
            values[slot], steps[slot] = arrival, i * size + memory


@inlined
def earliest_in_turn(paths: Floats, j: int, disk: GrowingDisk) -> float:
    """Return a time before which a turning evader is not captured: from where its turn begins."""
    speed = math.hypot(paths[j, VELOCITY_X], paths[j, VELOCITY_Y])
    distance = math.hypot(paths[j, START_X] - disk.x, paths[j, START_Y] - disk.y)
    time = (distance - disk.radius + disk.speed * disk.time) / (disk.speed + speed)
    return max(disk.time, time * (1.0 - _ROUNDING))


@compiled
def trace_walk(
    n: int, weight: int, bits: int, end: int, weights: Ints, steps: Int32s, walk: Ints
) -> int:
    """Write the walk that ends in a state, the last capture first; return how many there are."""
    size, length, state = 1 << bits, 0, end
    while state >= 0:
        i = state // size
        walk[length] = i
        length += 1
        state, weight = steps[slot_of(n, size, weight, 0) + state], weight - weights[i]
    return length
