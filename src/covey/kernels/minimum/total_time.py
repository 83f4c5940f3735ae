"""The least sum of all capture times over every sequence: depth first, with undominated labels.

For the last capture alone, the earliest arrival for each (set of captured evaders, last captured)
is all that the rest of a sequence needs to know. For the sum the rest needs the sum so far as well,
and the two orders differ: one beginning arrives earlier, another has the smaller sum. What follows
costs no less after a later arrival (the pursuer can shadow the evader it captured). So a beginning
is dominated by another with the same captured set and last evader that arrives no later *and* has
no larger sum. The dynamic programme over undominated pairs is exact.

Pairs are many in the worst case, so memory is bounded another way. Beginnings are extended depth
first, the nearest evader first, and one pair of each state is remembered. Forgotten pairs cost
time, never exactness (docs/decisions/0009).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import ABANDON, Floats, Ints, Workspace, floats, ints, padded, padded_rows
from covey.kernels.capture.interception import capture_in_turn, earliest_capture
from covey.kernels.capture.path import TURN_END, VELOCITY_X, VELOCITY_Y
from covey.kernels.capture.pursuit import Pursuit, disk_after, initial_disk
from covey.kernels.capture.straight_legs import LINES, captures_on_lines, set_lines

MOST_FOR_SUMS = 20
"""Largest team that the minimum of sums serves: its tables take 24 N 2^N bytes, 0.5 GB for 20."""

_ROUNDING = 1e-13


class TotalTimeScratch(NamedTuple):
    """Arrays of `min_total_time` for up to n evaders; sets are bit masks, a depth is their size."""

    times: Floats  # (2**n * n,) of the remembered pairs, by set and last captured
    sums: Floats  # (2**n * n,)
    stamps: Ints  # (2**n * n,) the call that remembered the pair
    call: Ints  # (1,) number of the present call
    lines: Floats  # (6, padded(n))
    arrivals: Floats  # (n + 1, padded(n)) from the beginning at each depth
    slacks: Floats  # (n,) by how much a capture on the way may bring another capture forward
    order: Ints  # (n,) the present beginning
    tried: Ints  # (n + 1,) sets
    spent: Floats  # (n + 1,) sums
    stop: Ints  # (1,) of the workspace


@inlined
def total_time_scratch(workspace: Workspace, n: int) -> TotalTimeScratch:
    """Carve the scratch of `min_total_time`: 24 N 2^N bytes."""
    states = n << n
    return TotalTimeScratch(
        floats(workspace, states),
        floats(workspace, states),
        ints(workspace, states),
        ints(workspace, 1),
        padded_rows(workspace, LINES),
        padded_rows(workspace, n + 1),
        floats(workspace, n),
        ints(workspace, n),
        ints(workspace, n + 1),
        floats(workspace, n + 1),
        workspace.stop,
    )


@compiled
def min_total_time(
    paths: Floats, pursuit: Pursuit, bound: float, sequence: Ints, scratch: TotalTimeScratch
) -> tuple[float, int]:
    """Return the least sum of the capture times of a sequence, if it is below `bound`.

    At each depth, the nearest evader that was not tried yet is captured next. A beginning is given
    up where a lower bound of its sums reaches `bound`, or where the remembered pair of its state
    dominates it.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    bound
        inf, or an upper bound.
    sequence
        (n,) the order that attains the minimum; left alone where no sequence beats the bound.
        Modified in place.
    scratch
        With room for n evaders; modified in place.

    Returns
    -------
    float
        The minimum, or `bound` where no sequence beats it.
    int
        How many interceptions were computed.
    """
    n, arrivals, order = len(paths), scratch.arrivals, scratch.order
    tried, spent = scratch.tried, scratch.spent
    _begin(paths, pursuit, scratch)
    captured, depth, interceptions = 0, 0, n
    while depth >= 0 and scratch.stop[0] != ABANDON:
        i = _nearest(n, arrivals[depth], tried[depth])
        if i < 0:
            depth -= 1
            if depth >= 0:
                captured ^= 1 << order[depth]
            continue
        tried[depth] |= 1 << i
        time = arrivals[depth, i]
        total, larger = spent[depth] + time, captured | 1 << i
        if _lower_bound(arrivals[depth], larger, time, total, scratch.slacks[:n]) >= bound:
            continue
        order[depth] = i
        if depth == n - 1:
            if total < bound:
                bound = total
                for k in range(n):
                    sequence[k] = order[k]
            continue
        if _is_dominated(larger * n + i, time, total, scratch):
            continue
        captured, depth = larger, depth + 1
        tried[depth], spent[depth] = captured, total
        _arrive(paths, pursuit, i, time, captured, scratch.lines, arrivals[depth])
        interceptions += n - depth
    return bound, interceptions


@inlined
def _begin(paths: Floats, pursuit: Pursuit, scratch: TotalTimeScratch) -> None:
    """Write what the beginning without captures leads to."""
    scratch.call[0] += 1
    set_lines(paths, scratch.lines)
    for i in range(len(paths)):
        speed = math.hypot(paths[i, VELOCITY_X], paths[i, VELOCITY_Y])
        scratch.slacks[i] = pursuit.later_radius / (pursuit.speed - speed)
        scratch.arrivals[0, i] = earliest_capture(paths, i, initial_disk(pursuit))
    scratch.tried[0], scratch.spent[0] = 0, 0.0


@compiled
def _nearest(n: int, arrivals: Floats, tried: int) -> int:
    """Return the untried evader that can be captured soonest, or -1."""
    nearest, soonest = -1, math.inf
    for i in range(n):
        if not tried >> i & 1 and arrivals[i] < soonest:
            nearest, soonest = i, arrivals[i]
    return nearest


@compiled
def _lower_bound(
    arrivals: Floats, captured: int, time: float, total: float, slacks: Floats
) -> float:
    """Return a lower bound of all sums of sequences that go on from here.

    Nobody is captured before the pursuer could be there directly, less what captures on the way
    grant it: after each the pursuer may start up to 2ρ from where it was.
    """
    n, remaining = len(slacks), 0
    for i in range(n):
        remaining += not captured >> i & 1
    for i in range(n):
        if not captured >> i & 1:
            total += max(time, arrivals[i] - remaining * slacks[i])
    return total * (1.0 - _ROUNDING)


@compiled
def _is_dominated(state: int, time: float, total: float, scratch: TotalTimeScratch) -> bool:
    """Whether the remembered pair dominates this pair; if not, remember this pair."""
    remembered = scratch.stamps[state] == scratch.call[0]
    if remembered and scratch.times[state] <= time and scratch.sums[state] <= total:
        return True
    scratch.stamps[state] = scratch.call[0]
    scratch.times[state], scratch.sums[state] = time, total
    return False


@compiled
def _arrive(
    paths: Floats,
    pursuit: Pursuit,
    last: int,
    time: float,
    captured: int,
    lines: Floats,
    arrivals: Floats,
) -> None:
    """Write when each evader can be captured after `last` was captured at `time`."""
    n, disk = len(paths), disk_after(paths, last, time, pursuit)
    captures_on_lines(lines, disk, arrivals[: padded(n)])
    for i in range(n):
        if not captured >> i & 1 and arrivals[i] < paths[i, TURN_END]:
            arrivals[i] = capture_in_turn(paths, i, disk)
