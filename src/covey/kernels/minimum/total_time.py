"""The least sum of all capture times over every sequence: depth first, with undominated labels.

For the last capture alone, the earliest arrival for each (set of captured evaders, last captured)
is all that a sequence needs to know of its beginning. For the sum it needs the sum so far as well,
and there the orders differ: one arrives earlier, another has the smaller sum. What follows costs
no less for whoever arrives later (the pursuer can shadow the evader it caught), so a beginning is
dominated by another with the same captured and last that is no later *and* has no larger sum, and
the dynamic programme over undominated pairs is exact.

Pairs are many in the worst case, so memory is bounded another way: beginnings are followed depth
first, the nearest evader first, and one pair of each state is remembered. Those that are forgotten
cost time, never exactness (docs/decisions/0009).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.interception import capture_in_turn, earliest_capture
from covey.kernels.capture.path import TURN_END, VELOCITY_X, VELOCITY_Y, position
from covey.kernels.capture.straight_legs import captures_on_lines, make_lines, padded, set_lines

_ROUNDING = 1e-13


class TotalScratch(NamedTuple):
    """Arrays of `least_total` for up to n evaders; sets are bit masks, a depth is their size."""

    times: Floats  # (2**n * n,) of the pairs remembered, by set and last captured
    sums: Floats  # (2**n * n,)
    stamps: Ints  # (2**n * n,) in which call
    call: Ints  # (1,) the present one
    lines: Table
    arrivals: Table  # (n + 1, padded(n)) from the beginning at each depth
    reliefs: Floats  # (n,) by how much a capture on the way may bring another one forward
    order: Ints  # (n,) the beginning that is followed
    tried: Ints  # (n + 1,) sets
    spent: Floats  # (n + 1,) sums


@allocating
def total_scratch(n: int) -> TotalScratch:
    """Allocate the scratch of `least_total`: 24 N 2^N bytes."""
    states = n << n
    return TotalScratch(
        np.empty(states),
        np.empty(states),
        np.zeros(states, np.int64),
        np.zeros(1, np.int64),
        make_lines(n),
        np.empty((n + 1, padded(n))),
        np.empty(n),
        np.empty(n, np.int64),
        np.empty(n + 1, np.int64),
        np.empty(n + 1),
    )


@compiled
def least_total(
    paths: Table, n: int, pursuit: Pursuit, bound: float, sequence: Ints, scratch: TotalScratch
) -> tuple[float, int]:
    """Least sum of the capture times of a sequence of all `n` evaders that is below `bound`.

    Returns it and the number of interceptions computed, and writes its order to `sequence`; returns
    `bound` and leaves `sequence` alone where no sequence beats it.
    """
    arrivals, order, tried, spent = scratch.arrivals, scratch.order, scratch.tried, scratch.spent
    scratch.call[0] += 1
    set_lines(paths, n, scratch.lines)
    for i in range(n):
        speed = math.hypot(paths[i, VELOCITY_X], paths[i, VELOCITY_Y])
        scratch.reliefs[i] = pursuit.later_radius / (pursuit.speed - speed)
        arrivals[0, i] = earliest_capture(
            paths, i, pursuit.center_x, pursuit.center_y, pursuit.first_radius, 0.0, pursuit.speed
        )
    caught, depth, interceptions = 0, 0, n
    tried[0], spent[0] = 0, 0.0
    while depth >= 0:
        i = _nearest(n, arrivals[depth], tried[depth])
        if i < 0:
            depth -= 1
            if depth >= 0:
                caught ^= 1 << order[depth]
            continue
        tried[depth] |= 1 << i
        time = arrivals[depth, i]
        total, larger = spent[depth] + time, caught | 1 << i
        if _at_least(n, arrivals[depth], larger, time, total, scratch.reliefs) >= bound:
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
        caught, depth = larger, depth + 1
        tried[depth], spent[depth] = caught, total
        _arrive(paths, n, pursuit, i, time, caught, scratch.lines, arrivals[depth])
        interceptions += n - depth
    return bound, interceptions


@compiled
def _nearest(n: int, arrivals: Floats, tried: int) -> int:
    """Whoever of the untried can be captured soonest, or -1."""
    nearest, soonest = -1, math.inf
    for i in range(n):
        if not tried >> i & 1 and arrivals[i] < soonest:
            nearest, soonest = i, arrivals[i]
    return nearest


@compiled
def _at_least(
    n: int, arrivals: Floats, caught: int, time: float, total: float, reliefs: Floats
) -> float:
    """A sum that no sequence which goes on from here falls below.

    Nobody is captured before the pursuer could be there directly, less what captures on the way
    grant it: each lets it start up to 2ρ from where it was.
    """
    ahead = 0
    for i in range(n):
        ahead += not caught >> i & 1
    for i in range(n):
        if not caught >> i & 1:
            total += max(time, arrivals[i] - ahead * reliefs[i])
    return total * (1.0 - _ROUNDING)


@compiled
def _is_dominated(state: int, time: float, total: float, scratch: TotalScratch) -> bool:
    """Whether the pair remembered of this state is as early and as small; if not, remember this."""
    remembered = scratch.stamps[state] == scratch.call[0]
    if remembered and scratch.times[state] <= time and scratch.sums[state] <= total:
        return True
    scratch.stamps[state] = scratch.call[0]
    scratch.times[state], scratch.sums[state] = time, total
    return False


@compiled
def _arrive(
    paths: Table,
    n: int,
    pursuit: Pursuit,
    last: int,
    time: float,
    caught: int,
    lines: Table,
    arrivals: Floats,
) -> None:
    """Write when each evader can be captured after `last` was captured at `time`."""
    x, y = position(paths, last, time)
    captures_on_lines(lines, n, x, y, pursuit.later_radius, time, pursuit.speed, arrivals)
    for i in range(n):
        if not caught >> i & 1 and arrivals[i] < paths[i, TURN_END]:
            arrivals[i] = capture_in_turn(paths, i, x, y, pursuit.later_radius, time, pursuit.speed)
