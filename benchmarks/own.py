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

import covey
from covey.kernels.maximum.initial_guesses import Guesses, new_elite
from covey.kernels.maximum.multistart import RADIUS_RANDOM, RADIUS_WARM, multistart, refine
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.maximum.working_set import copy_working_set, new_working_set
from covey.kernels.play.policy import UPDATE_STEPS
from covey.planning.compiled_objective import compiled_objective
from covey.planning.guarantee import pursuit_of
from covey.planning.multistart import MAX_STEPS
from covey.planning.open_loop import DEFAULT_TOLERANCE
from covey.planning.workspace import workspace
from covey.players.teams.open_loop import REPLAN_TOLERANCE
from moments import Answer
from stopwatch import now

WARM = Options(RADIUS_WARM, REPLAN_TOLERANCE, UPDATE_STEPS)
COLD = Options(RADIUS_RANDOM, DEFAULT_TOLERANCE, MAX_STEPS)


@numba.njit
def timed_replan(repeats, problem, guesses, options, lower_bound, left, iterate, scratch):
    """Median time and value of replans from what is `left` of a plan, turns and working set."""
    value, reading, seconds = 0.0, np.zeros(2, np.int64), np.empty(repeats)
    for k in range(repeats):
        iterate.turns[:] = left.turns
        copy_working_set(left.working_set, len(left.turns), iterate.working_set)
        start = now(reading)
        value, _, _, _ = refine(problem, guesses, options, lower_bound, iterate, scratch)
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


class Compiled:
    """As in a compiled game."""

    name = "covey, compiled"
    largest = 18

    def __init__(self, size):
        self.repeats = 5 if size <= 10 else 1  # the median counts
        self.scratch = workspace(size)
        self.objective = compiled_objective(covey.LastCapture(), size)
        self.iterate = Iterate(np.zeros(size), new_working_set(size))
        self.uniforms, self.elite = np.empty((0, size)), new_elite(size)

    def warm(self, moment):
        """Replan from what is left of the last plan."""
        return Answer(*timed_replan(self.repeats, *self.warm_arguments(moment)))

    def cold(self, moment):
        """Plan from straight flight away."""
        return Answer(*timed_plan(self.repeats, *self.cold_arguments(moment)))

    def warm_arguments(self, moment):
        """What `timed_replan` wants besides the number of repeats."""
        team, disk, turns = moment.now
        problem = Problem(team.as_rows(), pursuit_of(disk), self.objective)
        guesses, left = self._guesses(0), Iterate(turns, moment.working_set)
        return problem, guesses, WARM, moment.lower_bound, left, self.iterate, self.scratch

    def cold_arguments(self, moment):
        """What `timed_plan` wants besides the number of repeats."""
        team, disk, _ = moment.first
        problem = Problem(team.as_rows(), pursuit_of(disk), self.objective)
        return problem, self._guesses(1), COLD, self.iterate, self.scratch

    def _guesses(self, size):
        return Guesses(self.uniforms, self.elite, 0, size)


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
