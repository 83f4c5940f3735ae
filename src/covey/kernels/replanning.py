"""How an iterative open-loop team plans again, and how a committed pursuer keeps its sequence.

Both are kernels on the living only, so that a compiled game and a game with strategies in Python
run the same code.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.ascent import AscentScratch, Columns, ascend
from covey.kernels.search import WARM_BOX, SearchScratch, search
from covey.kernels.sequence import capture_times
from covey.kernels.subsets import least_time
from covey.kernels.types import Floats, Ints, Pursuit, Table


@compiled
def replan(
    evaders: Table,
    n: int,
    pursuit: Pursuit,
    noise: Table,
    followed: int,
    tolerance: float,
    most_steps: int,
    turns: Floats,
    columns: Columns,
    scratch: SearchScratch,
) -> float:
    """Improve the `turns` that are flown, from them and `followed` other starts; return the value.

    Never worse than the turns given.
    """
    value, _, _ = ascend(
        evaders, pursuit, turns[:n], columns, WARM_BOX, tolerance, most_steps, scratch.ascent
    )
    value, _, _ = search(
        evaders,
        n,
        pursuit,
        noise,
        0,
        followed,
        value,
        tolerance,
        most_steps,
        turns,
        columns,
        scratch,
    )
    return value


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


@compiled
def commit(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    margin: float,
    known: bool,
    sequence: Ints,
    times: Floats,
    scratch: AscentScratch,
) -> None:
    """Replace the `sequence` a pursuer follows where another is better by more than `margin`.

    The margin is relative to the time that the one followed still takes; inf keeps it for ever.
    Where none is `known` yet, the best is taken.
    """
    bound = math.inf
    if known:
        bound = capture_times(paths, pursuit, sequence[:n], times) * (1.0 - margin)
    if bound > 0.0:
        least_time(
            paths,
            n,
            pursuit,
            bound,
            sequence,
            scratch.subsets,
        )
