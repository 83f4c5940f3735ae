"""Weights of visits: raised where the least walk skips an evader, lowered where it repeats one.

Subgradient steps, after Held and Karp (1971): a walk pays for the time of a capture by the weight
that it collects there. Shares are real numbers, weights are whole.
"""

from __future__ import annotations

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints
from covey.kernels.minimum.large.scratch import LargeScratch

MEAN_WEIGHT = 5  # an evader's share in the mean is 1

_LEAST_SHARE = 0.02
_MEMORY = 0.3  # of the step before in a step


@compiled
def set_weights(shares: Floats, weights: Ints) -> int:
    """Write the weights of shares; return their sum."""
    total = 0
    for i in range(len(shares)):
        weights[i] = max(1, round(MEAN_WEIGHT * shares[i]))
        total += weights[i]
    return total


@compiled
def count_visits(n: int, walk: Ints, visits: Ints) -> bool:
    """Write how often a walk visits each of n evaders; return whether each is visited once."""
    for i in range(n):
        visits[i] = 0
    for k in range(len(walk)):
        visits[walk[k]] += 1
    is_sequence = len(walk) == n
    for i in range(n):
        is_sequence = is_sequence and visits[i] == 1
    return is_sequence


@compiled
def step_shares(n: int, gap: float, scratch: LargeScratch) -> None:
    """Change the shares of n evaders by a step against the visits of the least walk.

    `gap` is by how much the walk's time is to rise, relative to the upper bound.
    """
    shares, direction, square, total = scratch.shares, scratch.direction, 0.0, 0.0
    for i in range(n):
        direction[i] = _MEMORY * direction[i] + 1.0 - scratch.visits[i]
        square += direction[i] * direction[i]
    for i in range(n):
        if square > 0.0:
            shares[i] += gap * n / square * direction[i]
        shares[i] = max(shares[i], _LEAST_SHARE)
        total += shares[i]
    for i in range(n):
        shares[i] *= n / total
