"""The columns: the few capture sequences that matter to a plan, carried from step to step.

The value of a plan is the least of its columns as soon as the worst sequence is among them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled, inlined
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.path import PATH
from covey.kernels.capture.sequence import capture_times, measured


class Columns(NamedTuple):
    """The sequences that matter, kept from one ascent to the next: first `used[0]` rows."""

    used: Ints  # (1,) how many rows
    sequences: Ints  # (m, n)
    weights: Floats  # (m,) multipliers of the last step: the sequences' shares in its curvature


class Point(NamedTuple):
    """What there is to know at some turns of n evaders, for up to m columns."""

    paths: Table  # (n, PATH)
    times: Table  # (m, n) capture times of each column
    values: Floats  # (m,) what is measured of them


@compiled
def most_columns(n: int) -> int:
    """How many sequences are carried for a team of n: n + 1 can be active at once."""
    return 2 * n + 4


@allocating
def make_columns(n: int) -> Columns:
    """Columns of a team of up to n, none yet."""
    m = most_columns(n)
    return Columns(np.zeros(1, np.int64), np.empty((m, n), np.int64), np.zeros(m))


@allocating
def make_point(n: int) -> Point:
    """Room for a point of up to n turns."""
    m = most_columns(n)
    return Point(np.empty((n, PATH)), np.empty((m, n)), np.empty(m))


@compiled
def evaluate(point: Point, n: int, pursuit: Pursuit, total: bool, columns: Columns) -> float:
    """Write what the columns come to on the point's paths; return the least."""
    least = math.inf
    for s in range(columns.used[0]):
        least = min(least, evaluate_one(point, n, pursuit, total, columns, s))
    return least


@inlined
def evaluate_one(
    point: Point, n: int, pursuit: Pursuit, total: bool, columns: Columns, s: int
) -> float:
    """Write what column s comes to, and return it."""
    capture_times(point.paths, pursuit, columns.sequences[s, :n], point.times[s])
    point.values[s] = measured(point.times[s], n, total)
    return point.values[s]


@compiled
def join(columns: Columns, n: int, sequence: Ints, values: Floats) -> int:
    """Add a column; where all rows are taken, in place of the idle one of the largest value."""
    slot = columns.used[0]
    if slot < len(columns.weights):
        columns.used[0] += 1
    else:
        slot, idlest = 0, -math.inf
        for s in range(len(columns.weights)):
            if columns.weights[s] == 0.0 and values[s] > idlest:
                slot, idlest = s, values[s]
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
        move_without(columns, n, row, s, kept)
        columns.weights[kept] = columns.weights[s]
        twin = _twin(columns, kept, n - 1)
        if twin >= 0:
            columns.weights[twin] += columns.weights[kept]
        else:
            kept += 1
    columns.used[0] = kept


@inlined
def move_without(columns: Columns, n: int, row: int, s: int, slot: int) -> None:
    """Write sequence s of n without `row` to an earlier slot, or its own; later rows move up."""
    k = 0
    for j in range(n):
        i = columns.sequences[s, j]
        if i != row:
            columns.sequences[slot, k] = i - (i > row)
            k += 1


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
