"""The arrays of the minimum for large teams."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import inlined
from covey.kernels.arrays import (
    GO_ON,
    LABELS,
    MOST_NEIGHBOURS,
    MOST_WEIGHT,
    Floats,
    Int32s,
    Ints,
    WalkMemory,
    padded,
    walk_states,
)

LOWER, UPPER, STATES = range(3)
"""Slots of what is known: all sequences take at least and some takes at most so long; how many
states and labels were extended in this call."""


class State(NamedTuple):
    """Of a walk, from which it is extended."""

    last: int  # the evader that it ends with
    memory: int
    first_slot: int  # of the states of this evader with the same weight
    weight_left: int  # that is still to be collected


class LargeScratch(NamedTuple):
    """Arrays of the minimum for n evaders. A set of evaders is a bit mask."""

    lines: Floats  # (6, padded(n)) or more columns
    neighbours: Ints  # (n, MOST_NEIGHBOURS + 1) how many there are, and who
    kept: Ints  # (4,) `SOLVED` and the slots after it
    shares: Floats  # (n,) of the evaders in the weight of a walk, 1 in the mean
    known: Floats  # (3,) `LOWER` and the slots after it
    first: Floats  # (padded(n),) when each evader can be captured first
    arrivals: Floats  # (padded(n),) when each evader can be captured next
    capture_times: Floats  # (n,) of a sequence
    direction: Floats  # (n,) in which the shares change
    best_shares: Floats  # (n,) shares of the largest lower bound
    least: Floats  # (2**MOST_NEIGHBOURS,) over the memories in a memory
    values: Floats  # (walk_states(n),) by weight, last captured and memory
    times: Floats  # (LABELS,) earliest arrivals
    weights: Ints  # (n,) of a visit
    visits: Ints  # (n,) how often the least walk visits each evader
    walk: Ints  # (MOST_WEIGHT * n + 1,) the least walk
    sequence: Ints  # (n,) the best sequence
    candidate: Ints  # (n,) sequence that may become the best
    trial: Ints  # (n,) the same after a move
    bits: Ints  # (n,) how the memory at an evader knows the neighbours of another
    remaining: Ints  # (n + 1,) who is not yet captured
    sets: Ints  # (LABELS,) labels: captured set and last captured
    steps: Int32s  # (walk_states(n),) last captured and memory before
    transitions: Int32s  # (n * n * 2**MOST_NEIGHBOURS,)
    before: Int32s  # (LABELS,) the label before
    table: Int32s  # (2 * LABELS,) hash table of labels
    stop: Ints  # (1,) of the workspace


@inlined
def large_scratch(memory: WalkMemory, lines: Floats, stop: Ints, n: int) -> LargeScratch:
    """Divide up the memory of large teams, in the same way for each call for n evaders."""
    m, states = padded(n), walk_states(n)
    real, whole, small = memory.floats, memory.ints, memory.int32s
    walk, labels = 8 + 8 * m, 8 + 8 * m + MOST_WEIGHT * m + 1
    sums = 8 + 6 * m
    values = sums + (1 << MOST_NEIGHBOURS)
    moves = states + (n * n << MOST_NEIGHBOURS)
    return LargeScratch(
        lines,
        memory.neighbours,
        whole[:4],
        real[8 : 8 + n],
        real[:3],
        real[8 + m : 8 + 2 * m],
        real[8 + 2 * m : 8 + 3 * m],
        real[8 + 3 * m : 8 + 3 * m + n],
        real[8 + 4 * m : 8 + 4 * m + n],
        real[8 + 5 * m : 8 + 5 * m + n],
        real[sums:values],
        real[values : values + states],
        real[values + states : values + states + LABELS],
        whole[8 : 8 + n],
        whole[8 + m : 8 + m + n],
        whole[walk:labels],
        whole[8 + 2 * m : 8 + 2 * m + n],
        whole[8 + 3 * m : 8 + 3 * m + n],
        whole[8 + 4 * m : 8 + 4 * m + n],
        whole[8 + 5 * m : 8 + 5 * m + n],
        whole[8 + 6 * m : 8 + 6 * m + n + 1],
        whole[labels : labels + LABELS],
        small[:states],
        small[states:moves],
        small[moves : moves + LABELS],
        small[moves + LABELS : moves + 3 * LABELS],
        stop,
    )


@inlined
def slot_of(n: int, size: int, weight: int, i: int) -> int:
    """Return the first slot of the states of a weight and a last evader, a slot a memory."""
    return (weight * n + i) * size


@inlined
def is_to_end(scratch: LargeScratch) -> bool:
    """Whether walks and labels are to be given up now."""
    return scratch.stop[0] != GO_ON
