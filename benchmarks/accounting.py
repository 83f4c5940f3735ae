"""Where the time of a plan goes, and how far it is from the floor.

Kernels are watched one by one, so the ordinary JIT compiles them: COVEY_JIT=1.

The floor is one dynamic programme over all subsets and nothing else: its interceptions times what
an interception costs by itself.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from typing import NamedTuple

import numba
import numpy as np

import covey
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import position
from covey.kernels.capture.pursuit import GrowingDisk
from covey.kernels.maximum.multistart import multistart, refine
from covey.kernels.maximum.working_set import copy_working_set
from covey.planning.border import paths_of, pursuit_of
from interpreted import Watch
from moments import moments
from own import Compiled, planned, replanned
from peers.peer import SAME
from stopwatch import now

MOST_GAMES, SECONDS = 20, 3.0
LONG = 7
"""Size from which on the calls of a solve are long enough to be timed in their order."""

PARTS = {
    "min_last_capture": "inner solves",
    "build_model": "derivatives",
    "linearise": "derivatives",
    "factor_hessian": "quadratic",
    "best_step": "quadratic",
    "corrected_step": "quadratic",
    "multipliers_changed": "quadratic",
    "escape_count": "quadratic",
    "evaluate": "working set",
    "set_paths": "paths",
}
"""The kernels in which a plan spends its time, and under which heading. The rest steers."""


@numba.njit
def timed_replan(
    repeats, problem, uniforms, restarts, options, lower_bound, left, iterate, scratch
):
    """Median time and value of replans from what is `left` of a plan, turns and working set."""
    value, reading, seconds = 0.0, np.zeros(2, np.int64), np.empty(repeats)
    for k in range(repeats):
        iterate.turns[:] = left.turns
        copy_working_set(left.working_set, len(left.turns), iterate.working_set)
        start = now(reading)
        value, _, _, _ = refine(problem, uniforms, restarts, options, lower_bound, iterate, scratch)
        seconds[k] = now(reading) - start
    return np.median(seconds), value


@numba.njit
def timed_plan(repeats, problem, guesses, options, iterate, scratch):
    """Median time and value of plans from one start."""
    value, reading, seconds = 0.0, np.zeros(2, np.int64), np.empty(repeats)
    for k in range(repeats):
        start = now(reading)
        value, _, _, _ = multistart(problem, guesses, options, -math.inf, iterate, scratch)
        seconds[k] = now(reading) - start
    return np.median(seconds), value


class Account(NamedTuple):
    """One task at one size, means over its games; times in microseconds, parts in per cent."""

    size: int
    task: str
    time: float
    interceptions: float  # of the dynamic programmes
    million_per_second: float
    ns_each: float  # an interception by itself
    floor_interceptions: int
    floor: float
    over_floor: float
    inner_solves: float
    derivatives: float
    quadratic: float
    working_set: float
    paths: float
    rest: float


def floor_interceptions(n):
    """Interceptions of one dynamic programme that drops nothing."""
    return n + n * (n - 1) * 2 ** (n - 2)


MEASURED: dict[int, list[Account]] = {}
"""By size."""


def accounts(size):
    """Return the `Account` of a warm replan and of a cold plan from one start."""
    own = Compiled(size)
    MEASURED[size] = [
        _account("warm", own, timed_replan, own.warm_arguments, replanned),
        _account("cold", own, timed_plan, own.cold_arguments, planned),
    ]
    return MEASURED[size]


def _account(task, own, driver, arguments, plan):
    size = len(own.iterate.turns)
    watch = Watch(PARTS)
    step_by_step = watch.interpreted(driver)
    if unknown := set(PARTS) - watch.met:
        raise AssertionError(f"no plan calls these kernels any more: {sorted(unknown)}")
    spent: Counter[str] = Counter()
    total, each, interceptions, begun = 0.0, 0.0, 0, time.perf_counter()
    for games, moment in enumerate(moments(size), start=1):
        given = arguments(moment)
        seconds, value = driver(own.repeats, *given)
        _, retraced = step_by_step(1, *given)
        if abs(retraced - value) > SAME * value:
            raise AssertionError(f"step by step, the solve came to {retraced}, not to {value}")
        total += seconds
        spent.update(watch.seconds(long=size >= LONG))
        each += interception_seconds(moment)
        interceptions += plan(moment).interceptions
        if games == MOST_GAMES or time.perf_counter() - begun > SECONDS:
            break
    shares = dict.fromkeys(PARTS.values(), 0.0)
    for kernel, part in PARTS.items():
        shares[part] += 100.0 * spent[kernel] / total
    least = floor_interceptions(size)
    floor = least * each
    return Account(
        size,
        task,
        1e6 * total / games,
        interceptions / games,
        1e-6 * interceptions / total,
        1e9 * each / games,
        least,
        1e6 * floor / games,
        total / floor,
        *shares.values(),
        100.0 - sum(shares.values()),
    )


def interception_seconds(moment):
    """Seconds of one interception by itself: those along random sequences, one after the other."""
    team, disk, turns = moment.before
    n, pursuit, paths = len(team), pursuit_of(disk), paths_of(team, disk, turns)
    sequences = np.random.default_rng(n).permuted(np.tile(np.arange(n), (100, 1)), axis=1)
    starts = []
    for sequence in sequences:
        times = covey.capture_times(team, disk, turns, sequence)
        places = [position(paths, i, time) for i, time in zip(sequence, times, strict=True)]
        starts += [(*place, time) for place, time in zip(places[:-1], times[:-1], strict=True)]
    return _each(paths, pursuit, sequences[:, 1:].ravel(), np.array(starts))


@numba.njit
def _each(paths, pursuit, evaders, starts):
    reading, seconds, total = np.zeros(2, np.int64), np.empty(20), 0.0
    for repeat in range(len(seconds)):
        begun = now(reading)
        for k in range(len(evaders)):
            x, y, time = starts[k]
            disk = GrowingDisk(x, y, pursuit.later_radius, time, pursuit.speed)
            total += earliest_capture(paths, evaders[k], disk)
        seconds[repeat] = (now(reading) - begun) / len(evaders)
    return np.median(seconds) if total > 0.0 else np.inf  # a sum that is used can't be left out
