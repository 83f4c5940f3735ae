"""The worst that a pursuer can do to given paths: the least over all capture sequences."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import allocating, compiled
from covey.kernels.arrays import Ints, Pursuit, Table
from covey.kernels.minimum.labels import SubsetScratch
from covey.kernels.minimum.last_capture import least_time, subset_scratch
from covey.kernels.minimum.total_time import TotalScratch, least_total, total_scratch


class WorstScratch(NamedTuple):
    """Arrays of the search for the worst sequence."""

    subsets: SubsetScratch
    totals: TotalScratch  # empty where the last capture alone counts


@allocating
def worst_scratch(n: int, total: bool) -> WorstScratch:
    """Allocate the scratch of `least_value` for teams of up to n."""
    return WorstScratch(subset_scratch(n), total_scratch(n if total else 0))


@compiled
def least_value(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    total: bool,
    bound: float,
    sequence: Ints,
    scratch: WorstScratch,
) -> tuple[float, int]:
    """Least of what is measured, the last capture or the sum of all, if it is below `bound`.

    Returns it and the number of interceptions computed, and writes its order to `sequence`; returns
    `bound` and leaves `sequence` alone where no sequence beats it.
    """
    if total:
        return least_total(paths, n, pursuit, bound, sequence, scratch.totals)
    return least_time(paths, n, pursuit, bound, sequence, scratch.subsets)
