"""This planner as a compiled game calls it, and as a caller in Python does.

For a game the arguments of a call are packed once, so a time holds the call of the library's entry
itself, less than half a microsecond, and not the packing.
"""

from __future__ import annotations

import dataclasses
import math
import time

import numpy as np

import covey
from covey.kernels.maximum.initial_guesses import Guesses, new_elite
from covey.kernels.maximum.multistart import RADIUS_RANDOM, RADIUS_WARM, multistart, refine
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.maximum.working_set import new_working_set
from covey.kernels.play.policy import UPDATE_STEPS
from covey.planning.border import pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.multistart import MAX_STEPS
from covey.planning.open_loop import DEFAULT_TOLERANCE
from covey.planning.workspace import workspace
from covey.players.teams.open_loop import REPLAN_TOLERANCE
from entry_calls import ready
from moments import Answer

WARM = Options(RADIUS_WARM, REPLAN_TOLERANCE, UPDATE_STEPS)
COLD = Options(RADIUS_RANDOM, DEFAULT_TOLERANCE, MAX_STEPS)


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
        *given, left, iterate, scratch = self.warm_arguments(moment)
        call = ready(refine, *given, iterate, scratch)

        def begin():
            iterate.turns[:] = left.turns
            for ours, given in zip(iterate.working_set, left.working_set, strict=True):
                ours[:] = given

        return self._timed(call, begin)

    def cold(self, moment):
        """Plan from straight flight away."""
        problem, guesses, options, iterate, scratch = self.cold_arguments(moment)
        call = ready(multistart, problem, guesses, options, -math.inf, iterate, scratch)
        return self._timed(call, lambda: None)

    def _timed(self, call, begin):
        """Median time of calls, each after it `begin`s anew, and the value that they come to."""
        seconds = []
        for _ in range(self.repeats):
            begin()
            start = time.perf_counter()
            call()
            seconds.append(time.perf_counter() - start)
        return Answer(float(np.median(seconds)), call.value())

    def warm_arguments(self, moment):
        """What `refine` is given, with what is left of the last plan before the iterate."""
        team, disk, turns = moment.now
        problem = Problem(team.as_rows(), pursuit_of(disk), self.objective)
        left = Iterate(turns, moment.working_set)
        return problem, self.uniforms, 0, WARM, moment.lower_bound, left, self.iterate, self.scratch

    def cold_arguments(self, moment):
        """What `multistart` is given, but for the value of the best plan so far: none."""
        team, disk, _ = moment.first
        problem = Problem(team.as_rows(), pursuit_of(disk), self.objective)
        return problem, Guesses(self.uniforms, self.elite, 0, 1), COLD, self.iterate, self.scratch


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
