"""The working set: the few capture sequences whose constraints z <= f_s an ascent keeps.

The value of a plan is the minimum over the working set as soon as the worst sequence is in it.
Sequences that are missing are found by the inner minimum and added (constraint generation).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import (
    Floats,
    IntMatrix,
    Ints,
    IntVector,
    Vector,
    Workspace,
    floats,
    int_rows,
    ints,
    path_rows,
    rows,
)


class WorkingSet(NamedTuple):
    """Capture sequences and their multipliers, kept from one ascent to the next."""

    used: IntVector  # (1,) how many rows are in use
    sequences: IntMatrix  # (m, n)
    weights: Vector  # (m,) multipliers of the last step, >= 0: the shares in the Hessian
    values: Vector  # (m,) objective of each sequence where the last ascent ended


class Evaluation(NamedTuple):
    """The working set at some turns."""

    paths: Floats  # (n, PATH)
    times: Floats  # (m, n) capture times of each sequence
    values: Floats  # (m,) objective of each sequence


@compiled
def capacity(n: int) -> int:
    """Return how many sequences a working set of n evaders holds: n + 1 can be active at once."""
    return 2 * n + 4


def new_working_set(n: int) -> WorkingSet:
    """Allocate an empty working set of up to n evaders."""
    m = capacity(n)
    return WorkingSet(np.zeros(1, np.int64), np.empty((m, n), np.int64), np.zeros(m), np.empty(m))


@inlined
def working_set_scratch(workspace: Workspace) -> WorkingSet:
    """Carve a working set; its contents are those of the call before."""
    n = workspace.size
    m = capacity(n)
    return WorkingSet(
        ints(workspace, 1), int_rows(workspace, m), floats(workspace, m), floats(workspace, m)
    )


@inlined
def evaluation_scratch(workspace: Workspace) -> Evaluation:
    """Carve an evaluation."""
    n = workspace.size
    m = capacity(n)
    return Evaluation(path_rows(workspace, n), rows(workspace, m), floats(workspace, m))


@compiled
def add(working_set: WorkingSet, sequence: Ints, values: Floats) -> int:
    """Add a sequence with multiplier 0; return its row.

    Where all rows are in use, the inactive sequence of the largest value is replaced.
    """
    row = working_set.used[0]
    if row < len(working_set.weights):
        working_set.used[0] += 1
    else:
        row, largest = 0, -math.inf
        for s in range(len(working_set.weights)):
            if working_set.weights[s] == 0.0 and values[s] > largest:
                row, largest = s, values[s]
    for k in range(len(sequence)):
        working_set.sequences[row, k] = sequence[k]
    working_set.weights[row] = 0.0
    return row


@compiled
def copy_working_set(source: WorkingSet, n: int, target: WorkingSet) -> None:
    """Copy the sequences of n evaders with their multipliers and values."""
    target.used[0] = source.used[0]
    for s in range(source.used[0]):
        target.weights[s], target.values[s] = source.weights[s], source.values[s]
        for k in range(n):
            target.sequences[s, k] = source.sequences[s, k]


@compiled
def drop_evader(working_set: WorkingSet, n: int, evader: int) -> None:
    """Remove a captured evader from the sequences of n evaders; merge sequences that become equal.

    The evaders behind the captured evader are renumbered.
    """
    kept = 0
    for s in range(working_set.used[0]):
        without(working_set.sequences[s, :n], evader, working_set.sequences[kept])
        working_set.weights[kept] = working_set.weights[s]
        duplicate = _find_duplicate(working_set, kept, n - 1)
        if duplicate >= 0:
            working_set.weights[duplicate] += working_set.weights[kept]
        else:
            kept += 1
    working_set.used[0] = kept


@inlined
def without(sequence: Ints, evader: int, target: Ints) -> None:
    """Write a sequence without one evader, and the evaders behind it renumbered, to `target`.

    `target` may be the sequence itself.
    """
    k = 0
    for j in range(len(sequence)):
        i = sequence[j]
        if i != evader:
            target[k] = i - (i > evader)
            k += 1


@compiled
def _find_duplicate(working_set: WorkingSet, s: int, n: int) -> int:
    """Return an earlier row with the sequence of row s, or -1."""
    for other in range(s):
        same = True
        for k in range(n):
            same = same and working_set.sequences[other, k] == working_set.sequences[s, k]
        if same:
            return other
    return -1
