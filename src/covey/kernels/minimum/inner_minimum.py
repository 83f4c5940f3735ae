"""The inner minimum of eq. (6): the worst that a pursuer can do to given paths."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints, Workspace, begin_carving, floats, ints, path_rows
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.minimum.labels import SubsetScratch, subset_scratch
from covey.kernels.minimum.last_capture import min_last_capture
from covey.kernels.minimum.total_time import TotalTimeScratch, min_total_time, total_time_scratch


class InnerScratch(NamedTuple):
    """Arrays of the inner minimum."""

    last_capture: SubsetScratch
    total_time: TotalTimeScratch  # empty where the workspace has no room for sums
    sequence: Ints  # (n,) for callers: one that attains the minimum
    times: Floats  # (n,) for callers: capture times of a sequence
    paths: Floats  # (n, PATH) for callers


@inlined
def inner_scratch(workspace: Workspace) -> InnerScratch:
    """Carve the scratch of the inner minimum, before all else."""
    begin_carving(workspace)
    n = workspace.size
    return InnerScratch(
        subset_scratch(workspace, n),
        total_time_scratch(workspace, n if workspace.total else 0),
        ints(workspace, n),
        floats(workspace, n),
        path_rows(workspace, n),
    )


@compiled
def inner_minimum(
    paths: Floats,
    pursuit: Pursuit,
    total: bool,
    bound: float,
    sequence: Ints,
    scratch: InnerScratch,
) -> tuple[float, int]:
    """Return the minimum of the last capture or, with `total`, of the sum, if below `bound`.

    Parameters, results and what is modified are as for `min_last_capture` and `min_total_time`.
    """
    if total:
        return min_total_time(paths, pursuit, bound, sequence, scratch.total_time)
    return min_last_capture(paths, pursuit, bound, sequence, scratch.last_capture)
