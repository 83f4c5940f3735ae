"""The inner minimum of eq. (6): the worst that a pursuer can do to given paths."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import (
    GO_ON,
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
from covey.kernels.minimum.greedy_sequence import greedy_sequence
from covey.kernels.minimum.labels import SubsetScratch, subset_scratch
from covey.kernels.minimum.large.minimum import large_minimum
from covey.kernels.minimum.large.scratch import LOWER, large_scratch
from covey.kernels.minimum.large.tours import Tour, improve
from covey.kernels.minimum.last_capture import min_last_capture
from covey.kernels.minimum.total_time import TotalTimeScratch, min_total_time, total_time_scratch


class InnerScratch(NamedTuple):
    """Arrays of the inner minimum."""

    fewest_walking: int  # evaders from which on walks come first
    largest_table: int  # evaders up to which a table may follow
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
        workspace.fewest_walking,
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

    Parameters, results and what is modified are as for `min_last_capture` and `min_total_time`. For
    large teams `large_minimum` comes first. Where it gives up before the minimum is proven, the
    table of all sets follows, if there is one and the flag `stop` isn't set; else the result is an
    upper bound, see `proven_minimum`.
    """
    if total:
        return min_total_time(paths, pursuit, bound, sequence, scratch.total_time)
    n, table, interceptions = len(paths), scratch.last_capture, 0
    if n >= scratch.fewest_walking:
        bound, interceptions, proven = large_minimum(
            paths, pursuit, bound, sequence, scratch.large, table.lines, table.stop
        )
        if proven or n > scratch.largest_table or table.stop[0] != GO_ON:
            return bound, interceptions
    value, more = min_last_capture(paths, pursuit, bound, sequence, table)
    scratch.large.floats[LOWER] = value
    return value, interceptions + more


@inlined
def proven_minimum(found: float, n: int, scratch: InnerScratch) -> float:
    """Return what is proven of the minimum that `inner_minimum` has just found for n evaders.

    A lower bound where the search was given up.
    """
    if n < scratch.fewest_walking:
        return found
    return min(scratch.large.floats[LOWER], found)


@compiled
def earlier_by_moves(
    paths: Floats,
    pursuit: Pursuit,
    start: Ints,
    bound: float,
    sequence: Ints,
    scratch: InnerScratch,
) -> float:
    """Return the last capture of a sequence of a large team that moves reach, if below `bound`.

    An upper bound of the inner minimum, in a fraction of its time.

    Parameters
    ----------
    paths, pursuit, bound
        As for `inner_minimum`.
    start
        (n,) where the moves begin; (0,): at a greedy sequence.
    sequence
        (n,) modified in place where the sequence beats the bound.
    scratch
        Modified in place.
    """
    n = len(paths)
    large = large_scratch(scratch.large, scratch.last_capture.lines, scratch.last_capture.stop, n)
    tour = Tour(large.candidate[:n], large.capture_times[:n], large.trial[:n])
    for k in range(len(start)):
        tour.sequence[k] = start[k]
    if len(start) == 0:
        greedy_sequence(paths, pursuit, tour.sequence, tour.times)
    time = improve(paths, pursuit, tour)
    if time < bound:
        for k in range(n):
            sequence[k] = tour.sequence[k]
    return min(time, bound)
