"""What a team wants, as the kernels see it: which captures count, and against whom."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.maximum.working_set import Columns, move_without


class Aim(NamedTuple):
    """The least over all sequences, or the mean over some, of the last capture or of the sum."""

    total: bool  # the sum of all capture times, not the last one alone
    expected: bool  # the mean over sequences that are drawn, not the least over all
    draws: Columns  # those sequences; their weights are probabilities


@inlined
def spent(since: float, n: int, total: bool) -> float:
    """By how much less a plan for n evaders is worth after a time in which it was flown."""
    return since * n if total else since


@compiled
def rule_out(draws: Columns, n: int, row: int) -> None:
    """Keep the sequences of n evaders that begin with the captured one, and take it out of them.

    Where none does, the pursuer isn't the one expected, and all are kept.
    """
    likely = 0.0
    for s in range(draws.used[0]):
        if draws.sequences[s, 0] == row:
            likely += draws.weights[s]
    kept = 0
    for s in range(draws.used[0]):
        if likely > 0.0 and draws.sequences[s, 0] != row:
            continue
        move_without(draws, n, row, s, kept)
        draws.weights[kept] = draws.weights[s] / likely if likely > 0.0 else draws.weights[s]
        kept += 1
    draws.used[0] = kept
