"""The objective as the kernels see it: which captures count, and over which sequences."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled
from covey.kernels.arrays import IntMatrix, IntVector, Vector
from covey.kernels.maximum.working_set import without


class Draws(NamedTuple):
    """The capture sequences that an expected pursuer draws from."""

    used: IntVector  # (1,) how many rows are in use
    sequences: IntMatrix  # (K, n)
    probabilities: Vector  # (K,)


class Objective(NamedTuple):
    """The minimum over all sequences, or the mean over drawn ones, of last capture or total."""

    total: bool  # the sum of all capture times; else the last capture
    expected: bool  # the mean over the drawn sequences; else the minimum over all sequences
    draws: Draws  # empty unless `expected`


@compiled
def elapsed_value(elapsed: float, n: int, total: bool) -> float:
    """Return by how much the value of a plan for n evaders falls while the plan is flown."""
    return elapsed * n if total else elapsed


@compiled
def condition_on_capture(draws: Draws, n: int, evader: int) -> None:
    """Condition the draws of n evaders on the capture of one evader first, and remove the evader.

    Where no drawn sequence begins with this evader, the pursuer isn't the expected one, and all
    sequences are kept.
    """
    likely = 0.0
    for s in range(draws.used[0]):
        if draws.sequences[s, 0] == evader:
            likely += draws.probabilities[s]
    kept = 0
    for s in range(draws.used[0]):
        if likely > 0.0 and draws.sequences[s, 0] != evader:
            continue
        without(draws.sequences[s, :n], evader, draws.sequences[kept])
        draws.probabilities[kept] = draws.probabilities[s] / (likely if likely > 0.0 else 1.0)
        kept += 1
    draws.used[0] = kept
