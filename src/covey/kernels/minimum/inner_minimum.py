"""The inner minimum of eq. (6): the worst that a pursuer can do to given paths."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import (
    Floats,
    Ints,
    WalkMemory,
    Workspace,
    begin_carving,
    floats,
    ints,
    path_rows,
)
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.minimum.labels import SubsetScratch, subset_scratch
from covey.kernels.minimum.large.minimum import large_minimum
from covey.kernels.minimum.last_capture import min_last_capture
from covey.kernels.minimum.total_time import TotalTimeScratch, min_total_time, total_time_scratch


class InnerScratch(NamedTuple):
    """Arrays of the inner minimum."""

    largest_table: int  # evaders up to which the table serves
    last_capture: SubsetScratch
    large: WalkMemory  # for larger teams
    total_time: TotalTimeScratch  # empty where the workspace has no room for sums
    sequence: Ints  # (n,) for callers: one that attains the minimum
    times: Floats  # (n,) for callers: capture times of a sequence
    paths: Floats  # (n, PATH) for callers


@inlined
def inner_scratch(workspace: Workspace) -> InnerScratch:
    """Carve the scratch of the inner minimum, before all else."""
    begin_carving(workspace)
    n, table = workspace.size, workspace.largest_table
    return InnerScratch(
        table,
        subset_scratch(workspace, min(n, table)),
        workspace.walks,
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

    Parameters, results and what is modified are as for `min_last_capture` and `min_total_time`; for
    large teams as for `large_minimum`, which may give up before the minimum is proven.
    """
    if total:
        return min_total_time(paths, pursuit, bound, sequence, scratch.total_time)
    if len(paths) > scratch.largest_table:
        table = scratch.last_capture
        return large_minimum(
            paths, pursuit, bound, sequence, scratch.large, table.lines, table.stop
        )
    return min_last_capture(paths, pursuit, bound, sequence, scratch.last_capture)
