"""The search for a plan: ascents from many initial guesses, in one thread or in parallel."""

from __future__ import annotations

import math
import os
import time
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np

from covey.kernels.arrays import Workspace
from covey.kernels.maximum.initial_guesses import BATCH, Guesses, insert, new_elite
from covey.kernels.maximum.multistart import (
    RADIUS_RANDOM,
    RADIUS_UNKNOWN_SET,
    RADIUS_WARM,
    is_better,
    multistart,
    refine,
)
from covey.kernels.maximum.problem import (
    CONVERGED,
    STEPS_USED_UP,
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.working_set import new_working_set
from covey.model.validation import Floats
from covey.planning.workspace import workspace

MAX_STEPS = 200
GUESS_STEPS = 50
"""Steps of an ascent while other guesses wait: one in a hundred takes more, and gains little."""


class Ascents(NamedTuple):
    """The best plan of some ascents, and their cost."""

    value: float
    status: int  # CONVERGED, STALLED or STEPS_USED_UP
    iterate: Iterate  # turns and working set of the plan
    starts: int  # ascents that ran
    steps: int
    interceptions: int
    in_time: bool  # whether no ascent was left out because of the deadline

    def joined(self, other: Ascents) -> Ascents:
        """Return the better plan, this plan among equals, and the cost of both."""
        best = other if is_better(other.value, self.value) else self
        return Ascents(
            *best[:3],
            starts=self.starts + other.starts,
            steps=self.steps + other.steps,
            interceptions=self.interceptions + other.interceptions,
            in_time=self.in_time and other.in_time,
        )


NONE = Ascents(-math.inf, CONVERGED, Iterate(np.empty(0), new_working_set(0)), 0, 0, 0, True)
"""What no ascent has found."""

LATE = NONE._replace(in_time=False)
"""What an ascent has found that was left out because of the deadline."""


class Search:
    """Ascents on one problem, which learn from the best plans so far.

    Parameters
    ----------
    problem
        What is maximised.
    tolerance
        A predicted gain below this, relative to the value, ends an ascent.
    uniforms
        Random numbers of the initial guesses, see `Guesses`.

    Attributes
    ----------
    size : int
        How many evaders are planned for.
    """

    def __init__(self, problem: Problem, tolerance: float, uniforms: Floats) -> None:
        self._problem, self._tolerance, self._uniforms = problem, tolerance, uniforms
        self.size = len(problem.evaders)
        self._elite = new_elite(self.size)

    def refine(self, iterate: Iterate) -> Ascents:
        """Ascend from a plan, which is overwritten."""
        known = iterate.working_set.used[0] > 0
        radius = RADIUS_WARM if known else RADIUS_UNKNOWN_SET
        options = Options(radius, self._tolerance, MAX_STEPS)
        found = refine(
            self._problem, self._uniforms, 0, options, -math.inf, iterate, self._workspace()
        )
        return _ascents(found, iterate, 1)

    def run(self, first: int, count: int) -> Ascents:
        """Ascend from `count` guesses, from guess number `first` on, in this thread."""
        iterate = Iterate(np.zeros(self.size), new_working_set(self.size))
        guesses = self._guesses(first, count)
        options = Options(RADIUS_RANDOM, self._tolerance, GUESS_STEPS)
        found = multistart(self._problem, guesses, options, -math.inf, iterate, self._workspace())
        return _ascents(found, iterate, count)

    def insert(self, ascents: Ascents) -> None:
        """Insert a plan into the elite, which later guesses vary."""
        if ascents.starts > 0:
            insert(self._elite, ascents.value, ascents.iterate.turns)

    def run_parallel(self, best: Ascents, count: int, deadline: float) -> Ascents:
        """Ascend from `count` guesses, a batch at a time in parallel; return the best with `best`.

        No ascent begins after the deadline, but for the first of all.
        """

        def ascend(guess: int) -> Ascents:
            late = time.perf_counter() > deadline and (guess > 0 or best.starts > 0)
            return LATE if late else self.run(guess, 1)

        with ThreadPoolExecutor(min(BATCH, os.cpu_count() or 1)) as executor:
            for first in range(0, count, BATCH):
                batch = range(first, min(first + BATCH, count))
                for ascents in list(executor.map(ascend, batch)):
                    self.insert(ascents)
                    best = best.joined(ascents)
                if not best.in_time:
                    break
        return best

    def finish(self, ascents: Ascents) -> Ascents:
        """Go on from the best plan if its steps were used up while other guesses waited."""
        if ascents.status != STEPS_USED_UP:
            return ascents
        refined = self.refine(ascents.iterate)  # never worse
        return refined._replace(
            starts=ascents.starts,
            steps=ascents.steps + refined.steps,
            interceptions=ascents.interceptions + refined.interceptions,
            in_time=ascents.in_time,
        )

    def _guesses(self, first: int, count: int) -> Guesses:
        return Guesses(self._uniforms, self._elite, first, count)

    def _workspace(self) -> Workspace:
        return workspace(self.size, self._problem.objective.total)


def _ascents(found: tuple[float, int, int, int], iterate: Iterate, starts: int) -> Ascents:
    value, status, steps, interceptions = found
    return Ascents(value, status, iterate, starts, steps, interceptions, in_time=True)
