"""Deadlines: until when a walk that collects a weight can begin at an evader, and end in time.

The walks of `walks`, run backwards from the upper bound. A sequence that has captured some evaders
can only be completed in time if a walk with the weight of the others can, of which the memory holds
nobody whom the sequence has captured.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, padded
from covey.kernels.capture.path import START_X, START_Y, position
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.kernels.capture.straight_legs import latest_departures
from covey.kernels.minimum.large.neighbours import FORBIDDEN
from covey.kernels.minimum.large.scratch import STATES, UPPER, LargeScratch, State, slot_of
from covey.kernels.minimum.large.walks import is_undominated

# Deadlines are later than need be at each capture, by this much of the bound and of the time that
# the coordinates take to fly, so that rounding drops no label.
_SLACK = 1e-13


@compiled
def set_completions(
    paths: Floats, pursuit: Pursuit, weight: int, bits: int, scratch: LargeScratch
) -> None:
    """Write until when each evader must be captured if a weight is to be collected from there on.

    Parameters
    ----------
    paths, pursuit, weight, bits
        As for `least_walk`.
    scratch
        With weights, transitions and the upper bound. Its values are modified in place: times by
        the weight from this evader on, the evader and its memory of whom the pursuer captured
        before; -inf: too late at any time.
    """
    n, size, values = len(paths), 1 << bits, scratch.values
    slack = _slack(paths, pursuit, scratch.known[UPPER])
    _begin(n, weight, size, slack, scratch)
    for q in range(1, weight):
        for i in range(n):
            begin = slot_of(n, size, q, i)
            for memory in range(size):
                time = values[begin + memory]
                if is_undominated(memory, time, -1.0, bits, scratch.least) and time >= 0.0:
                    scratch.known[STATES] += 1.0
                    state = State(i, memory, begin, weight - q)
                    _extend_back(paths, pursuit, slack, state, bits, scratch)
    for begin in range(0, slot_of(n, size, weight + 1, 0), size):
        _look_from_before(values[begin : begin + size], bits)


@inlined
def _begin(n: int, weight: int, size: int, slack: float, scratch: LargeScratch) -> None:
    """Write the walks of one capture."""
    values = scratch.values
    for slot in range(slot_of(n, size, weight + 1, 0)):
        values[slot] = -math.inf
    for i in range(n):
        values[slot_of(n, size, scratch.weights[i], i)] = scratch.known[UPPER] + slack


@inlined
def _slack(paths: Floats, pursuit: Pursuit, bound: float) -> float:
    """Return by how much deadlines are later than need be."""
    farthest = 0.0
    for i in range(len(paths)):
        farthest = max(farthest, abs(paths[i, START_X]), abs(paths[i, START_Y]))
    return _SLACK * (bound + farthest / pursuit.speed)


@inlined
def _extend_back(
    paths: Floats, pursuit: Pursuit, slack: float, state: State, bits: int, scratch: LargeScratch
) -> None:
    """Extend a state by each capture just before, that its memory and the weight left allow."""
    n, size, values = len(paths), 1 << bits, scratch.values
    transitions, departures = scratch.transitions, scratch.arrivals
    i, memory, begin, left = state
    deadline = values[begin + memory]
    x, y = position(paths, i, deadline)
    goal = GrowingDisk(x, y, pursuit.later_radius, deadline, pursuit.speed)
    for j in range(padded(n)):
        departures[j] = -math.inf
    latest_departures(scratch.lines, goal, slack, departures[: padded(n)])
    for j in range(n):
        after = transitions[(i * n + j) * size + memory]
        if after != FORBIDDEN and scratch.weights[j] <= left:
            slot = begin + slot_of(n, size, scratch.weights[j], j - i) + after
            values[slot] = max(values[slot], departures[j])


@inlined
def _look_from_before(deadlines: Floats, bits: int) -> None:
    """Turn deadlines by memory into the latest over all memories without any of some evaders."""
    size = 1 << bits
    for k in range(bits):
        for memory in range(size):
            if memory >> k & 1:
                deadlines[memory] = max(deadlines[memory], deadlines[memory ^ 1 << k])
    for memory in range(size // 2):
        other = size - 1 - memory
        deadlines[memory], deadlines[other] = deadlines[other], deadlines[memory]
