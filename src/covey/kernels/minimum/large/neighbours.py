"""Which evaders a walk remembers: ng-routes, after Baldacci, Mingozzi and Roberti (2011).

A walk that captures an evader forgets all whom it captured before but the neighbours of this
evader. So it may come back to an evader if it goes through one that has not this neighbour. Sets of
neighbours grow only where the least walk does so (Roberti and Mingozzi, 2014).
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Int32s, Ints
from covey.kernels.capture.path import position

FORBIDDEN = -1

_MANY, _FEW_NEIGHBOURS = 24, 4  # larger teams begin with one neighbour more


@compiled
def set_nearest(paths: Floats, horizon: float, neighbours: Ints) -> None:
    """Write who is near whom on the way to a time: the first neighbours of each evader.

    `neighbours` (n, MOST_NEIGHBOURS + 1) begins each row with how many there are; modified in
    place.
    """
    n = len(paths)
    count = min(_FEW_NEIGHBOURS + (n > _MANY), n - 1)
    for i in range(n):
        neighbours[i, 0] = 0
        for _ in range(count):
            nearest, least = -1, math.inf
            for j in range(n):
                if j != i and not is_neighbour(neighbours, i, j):
                    distance = _distance_on_the_way(paths, i, j, horizon)
                    if nearest < 0 or distance < least:
                        nearest, least = j, distance
            neighbours[i, 0] += 1
            neighbours[i, neighbours[i, 0]] = nearest


@compiled
def _distance_on_the_way(paths: Floats, i: int, j: int, horizon: float) -> float:
    """Return the distance of two evaders, in which early distances count more."""
    total = 0.0
    for quarter in range(1, 4):
        time = 0.25 * quarter * horizon
        x, y = position(paths, i, time)
        other_x, other_y = position(paths, j, time)
        total += math.hypot(x - other_x, y - other_y) / quarter
    return total


@compiled
def is_neighbour(neighbours: Ints, i: int, j: int) -> bool:
    """Whether j is a neighbour of i."""
    return _bit_of(neighbours, i, j) > 0


@compiled
def _bit_of(neighbours: Ints, i: int, j: int) -> int:
    """Return the bit by which the memory at i knows j, 0 if j is no neighbour."""
    for k in range(neighbours[i, 0]):
        if neighbours[i, k + 1] == j:
            return 1 << k
    return 0


@compiled
def memory_of(neighbours: Ints, i: int, captured: int) -> int:
    """Return the memory at i of a set of captured evaders."""
    memory = 0
    for k in range(neighbours[i, 0]):
        memory |= (captured >> neighbours[i, k + 1] & 1) << k
    return memory


@compiled
def memory_bits(n: int, neighbours: Ints) -> int:
    """Return how many bits the longest memory has."""
    most = 0
    for i in range(n):
        most = max(most, neighbours[i, 0])
    return most


@compiled
def set_transitions(n: int, bits: int, neighbours: Ints, known: Ints, transitions: Int32s) -> None:
    """Write the memory at j after a capture of i with each memory, `FORBIDDEN` if j is in it.

    Parameters
    ----------
    n, bits
        How many evaders there are, and how many bits their memories have.
    neighbours
        (n, MOST_NEIGHBOURS + 1).
    known
        (n,) scratch.
    transitions
        (n * n * 2**bits,) by i, j and memory; modified in place.
    """
    size = 1 << bits
    for i in range(n):
        for j in range(n):
            begin = (i * n + j) * size
            transitions[begin] = FORBIDDEN if i == j else _bit_of(neighbours, j, i)
            for k in range(bits):
                known[k] = 0
                if k < neighbours[i, 0]:
                    other = neighbours[i, k + 1]
                    known[k] = FORBIDDEN if other == j else _bit_of(neighbours, j, other)
                for memory in range(1 << k):
                    after = transitions[begin + memory]
                    forbidden = after == FORBIDDEN or known[k] == FORBIDDEN
                    transitions[begin + (1 << k) + memory] = (
                        FORBIDDEN if forbidden else after | known[k]
                    )


@compiled
def grow_along(walk: Ints, most: int, neighbours: Ints) -> bool:
    """Let all between two visits of an evader remember it, while they remember fewer than `most`.

    Returns whether a set has grown. `walk` may begin at either end.
    """
    grown = False
    for end in range(1, len(walk)):
        begin = end - 1
        while begin >= 0 and walk[begin] != walk[end]:
            begin -= 1
        if begin >= 0 and _has_room(walk[begin : end + 1], most, neighbours):
            for k in range(begin + 1, end):
                i = walk[k]
                if not is_neighbour(neighbours, i, walk[end]):
                    neighbours[i, 0] += 1
                    neighbours[i, neighbours[i, 0]] = walk[end]
                    grown = True
    return grown


@compiled
def _has_room(stretch: Ints, most: int, neighbours: Ints) -> bool:
    """Whether all between two visits of an evader know the evader, or can."""
    evader = stretch[0]
    for k in range(1, len(stretch) - 1):
        i = stretch[k]
        if neighbours[i, 0] >= most and not is_neighbour(neighbours, i, evader):
            return False
    return True
