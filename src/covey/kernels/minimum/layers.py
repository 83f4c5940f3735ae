"""The dynamic programme over subsets in two halves that run at the same time, layer by layer.

A layer is all sets of one size. Each half has labels of its own, so a set may be in both; its label
is the lesser one. While a layer is followed, nobody writes to it.
"""

from __future__ import annotations

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Pursuit, Table
from covey.kernels.minimum.labels import SubsetScratch, follow, label_of


@compiled
def follow_half(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    bound: float,
    halves: tuple[SubsetScratch, SubsetScratch],
    begins: tuple[int, int],
    ends: tuple[int, int],
    half: int,
    times: Floats,
) -> int:
    """Follow every second set of a layer; return the last place in the labels of this half.

    The layer is, in the labels of each half, what begins and ends there. `times` (n,) is scratch.
    """
    one, other = halves[0].labels, halves[1].labels
    last_place = ends[half] - 1
    for k in range(2):
        queue = halves[k].labels.queue
        for place in range(begins[k] + half, ends[k], 2):
            caught = queue[place]
            if k == 1 and one.places[caught] > 0:
                continue  # it was met in the first half
            for i in range(n):
                times[i] = min(label_of(caught, i, n, one), label_of(caught, i, n, other))
            last_place, _ = follow(
                paths, n, pursuit, bound, caught, times, 0, last_place, halves[half]
            )
    return last_place
