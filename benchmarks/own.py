"""This planner as a compiled game calls it, and as a caller in Python does.

What is compiled reads the clock itself: a call from Python would add the unpacking of its
arguments, some 10 µs, which no game pays.
"""

from __future__ import annotations

import dataclasses
import math
import time

import numba
import numpy as np
from covey.kernels.play.replanning import replan

import covey
from covey.kernels.maximum.multistart import search, search_scratch
from covey.kernels.maximum.working_set import copy_columns, make_columns
from covey.planning.compiled_objective import aim_of
from covey.planning.guarantee import pursuit_of
from covey.planning.multistart import MOST_STEPS
from covey.planning.open_loop import DEFAULT_TOLERANCE, start_noise
from covey.players.teams.open_loop import REPLAN_TOLERANCE
from moments import Answer
from stopwatch import now


@numba.njit
def timed_replan(
    repeats, evaders, pursuit, aim, noise, left, worth, known, turns, columns, scratch
):
    """Median time and value of replans from what is left of a plan and the columns it had."""
    n, value, reading, seconds = len(left), 0.0, np.zeros(2, np.int64), np.empty(repeats)
    for k in range(repeats):
        turns[:] = left
        copy_columns(known, n, columns)
        start = now(reading)
        value = replan(
            evaders,
            n,
            pursuit,
            aim,
            noise,
            0,
            REPLAN_TOLERANCE,
            MOST_STEPS,
            worth,
            turns,
            columns,
            scratch,
        )
        seconds[k] = now(reading) - start
    return np.median(seconds), value


@numba.njit
def timed_plan(repeats, evaders, pursuit, aim, noise, turns, columns, scratch):
    """Median time and value of plans from one start."""
    n, value, reading, seconds = len(turns), 0.0, np.zeros(2, np.int64), np.empty(repeats)
    for k in range(repeats):
        start = now(reading)
        value, _, _ = search(
            evaders,
            n,
            pursuit,
            aim,
            noise,
            1,
            -math.inf,
            DEFAULT_TOLERANCE,
            MOST_STEPS,
            turns,
            columns,
            scratch.elite,
            scratch,
        )
        seconds[k] = now(reading) - start
    return np.median(seconds), value


class Compiled:
    """As in a compiled game."""

    name = "covey, compiled"
    largest = 18

    def __init__(self, size):
        self.repeats = 5 if size <= 10 else 1  # the median counts
        self.noise, self.scratch = start_noise(0, 1, size), search_scratch(size)
        self.aim = aim_of(covey.LastCapture(), size)

    def warm(self, moment):
        """Replan from what is left of the last plan."""
        return Answer(*timed_replan(self.repeats, *self.warm_arguments(moment)))

    def cold(self, moment):
        """Plan from straight flight away."""
        return Answer(*timed_plan(self.repeats, *self.cold_arguments(moment)))

    def warm_arguments(self, moment):
        """What `timed_replan` wants besides the number of repeats."""
        team, disk, left = moment.now
        blank, known = make_columns(len(left)), moment.columns
        game = (team.as_rows(), pursuit_of(disk), self.aim)
        return *game, self.noise, left, moment.worth, known, left.copy(), blank, self.scratch

    def cold_arguments(self, moment):
        """What `timed_plan` wants besides the number of repeats."""
        team, disk, away = moment.first
        blank = make_columns(len(away))
        game = (team.as_rows(), pursuit_of(disk), self.aim)
        return *game, self.noise, away.copy(), blank, self.scratch


class FromPython:
    """`covey.plan`, with its checks, its scratch and its record."""

    name = "covey.plan"
    largest = 18

    def __init__(self, size):
        pass

    def warm(self, moment):
        """Replan from what is left of the last plan."""
        return _timed(lambda: replanned(moment))

    def cold(self, moment):
        """Plan from straight flight away."""
        return _timed(lambda: planned(moment))

    def best(self, moment):
        """Plan by default, the best of many starts."""
        return _timed(lambda: covey.plan(moment.first.team, moment.first.disk))


def replanned(moment):
    """Return the plan from what is left of the last one alone."""
    team, disk, left = moment.now
    warm_start = dataclasses.replace(moment.plan, turns=left)
    return covey.plan(team, disk, starts=1, warm_start=warm_start)


def planned(moment):
    """Return the plan from straight flight away alone."""
    return covey.plan(moment.first.team, moment.first.disk, starts=1)


def _timed(plan):
    start = time.perf_counter()
    value = plan().survival_time
    return Answer(time.perf_counter() - start, value)
