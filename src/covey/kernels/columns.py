"""The columns: the few capture sequences that matter to a plan, carried from step to step.

The value of a plan is the least of its columns as soon as the worst sequence is among them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.sequence import capture_times
from covey.kernels.types import Floats, Ints, Pursuit, Table


class Columns(NamedTuple):
    """The sequences that matter, kept from one ascent to the next: first `used[0]` rows."""

    used: Ints  # (1,) how many rows
    sequences: Ints  # (m, n)
    weights: Floats  # (m,) multipliers of the last step: the sequences' shares in its curvature


@compiled
def most_columns(n: int) -> int:
    """How many sequences are carried for a team of n: n + 1 can be active at once."""
    return 2 * n + 4


@allocating
def make_columns(n: int) -> Columns:
    """Columns of a team of up to n, none yet."""
    m = most_columns(n)
    return Columns(np.zeros(1, np.int64), np.empty((m, n), np.int64), np.zeros(m))


@compiled
def column_times(paths: Table, n: int, pursuit: Pursuit, columns: Columns, times: Table) -> float:
    """Write the capture times of all columns; return the least of their last ones."""
    value = math.inf
    for s in range(columns.used[0]):
        value = min(value, capture_times(paths, pursuit, columns.sequences[s, :n], times[s]))
    return value


@compiled
def join(columns: Columns, n: int, sequence: Ints, times: Floats) -> int:
    """Add a column; where all rows are taken, in place of the idle one that is captured last."""
    slot = columns.used[0]
    if slot < len(columns.weights):
        columns.used[0] += 1
    else:
        slot, idlest = 0, -math.inf
        for s in range(len(columns.weights)):
            if columns.weights[s] == 0.0 and times[s, n - 1] > idlest:
                slot, idlest = s, times[s, n - 1]
    for k in range(n):
        columns.sequences[slot, k] = sequence[k]
    columns.weights[slot] = 0.0
    return slot


@compiled
def copy_columns(source: Columns, n: int, target: Columns) -> None:
    """Copy the columns of n evaders."""
    target.used[0] = source.used[0]
    for s in range(source.used[0]):
        target.weights[s] = source.weights[s]
        for k in range(n):
            target.sequences[s, k] = source.sequences[s, k]


@compiled
def forget_captured(columns: Columns, n: int, row: int) -> None:
    """Take a captured evader out of the columns of n; columns that fall together become one."""
    kept = 0
    for s in range(columns.used[0]):
        k = 0
        for j in range(n):
            i = columns.sequences[s, j]
            if i != row:
                columns.sequences[kept, k] = i - (i > row)
                k += 1
        columns.weights[kept] = columns.weights[s]
        twin = _twin(columns, kept, n - 1)
        if twin >= 0:
            columns.weights[twin] += columns.weights[kept]
        else:
            kept += 1
    columns.used[0] = kept


@compiled
def _twin(columns: Columns, s: int, n: int) -> int:
    """An earlier column with the same sequence, or -1."""
    for other in range(s):
        same = True
        for k in range(n):
            same = same and columns.sequences[other, k] == columns.sequences[s, k]
        if same:
            return other
    return -1
