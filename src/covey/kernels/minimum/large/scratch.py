"""The arrays of the minimum for large teams."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import inlined
from covey.kernels.arrays import (
    ABANDON,
    FINISH,
    MOST_NEIGHBOURS,
    MOST_WEIGHT,
    Floats,
    Ints,
    WalkMemory,
    Workspace,
    floats,
    ints,
    padded,
    padded_rows,
)
from covey.kernels.capture.straight_legs import LINES

LOWER, UPPER, STATES = range(3)
"""Slots of what is known: all sequences take at least and some takes at most so long; how many
states and labels were extended in this call."""


ALWAYS_PROVEN = 20
"""Evaders up to which the minimum is always proven: labels suffice, and take a fraction of a
second."""


class LargeScratch(NamedTuple):
    """Arrays of the minimum for up to n evaders. A set of evaders is a bit mask."""

    memory: WalkMemory
    lines: Floats  # (6, padded(n))
    first: Floats  # (padded(n),) when each evader can be captured first
    arrivals: Floats  # (padded(n),) when each evader can be captured next
    known: Floats  # (3,)
    weights: Ints  # (n,) of a visit
    best_weights: Ints  # (n,) those of the largest lower bound
    visits: Ints  # (n,) how often the least walk visits each evader
    walk: Ints  # (MOST_WEIGHT * n + 1,) the least walk
    sequence: Ints  # (n,) the best sequence
    candidate: Ints  # (n,) sequence that may become the best
    trial: Ints  # (n,) the same after a move
    times: Floats  # (n,) capture times of a sequence
    direction: Floats  # (n,) in which the weights change
    best_shares: Floats  # (n,) shares of the largest lower bound
    least: Floats  # (2**MOST_NEIGHBOURS,) over the memories in a memory
    bits: Ints  # (n,) where each neighbour of one evader is among the neighbours of another
    remaining: Ints  # (n,) who is not yet captured
    stop: Ints  # (1,) of the workspace


@inlined
def large_scratch(workspace: Workspace, n: int) -> LargeScratch:
    """Carve the scratch of the minimum for up to n evaders."""
    return LargeScratch(
        workspace.walks,
        padded_rows(workspace, LINES),
        floats(workspace, padded(n)),
        floats(workspace, padded(n)),
        floats(workspace, 3),
        ints(workspace, n),
        ints(workspace, n),
        ints(workspace, n),
        ints(workspace, MOST_WEIGHT * n + 1),
        ints(workspace, n),
        ints(workspace, n),
        ints(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, n),
        floats(workspace, 1 << MOST_NEIGHBOURS),
        ints(workspace, n),
        ints(workspace, n),
        workspace.stop,
    )


@inlined
def slot_of(n: int, size: int, weight: int, i: int) -> int:
    """Return the first slot of the states of a weight and a last evader, a slot a memory."""
    return (weight * n + i) * size


@inlined
def is_to_end(n: int, scratch: LargeScratch) -> bool:
    """Whether the minimum for n evaders is to be given up now."""
    stop = scratch.stop[0]
    return stop == ABANDON or (stop == FINISH and n > ALWAYS_PROVEN)
