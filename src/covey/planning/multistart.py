"""The search for a plan: ascents from many initial guesses, in one thread or in parallel."""

from __future__ import annotations

import math
import os
import time
from functools import partial
from typing import NamedTuple

import numpy as np

from covey.kernels.arrays import FEWEST_WALKING, GO_ON, Workspace
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
    Iterate,
    Options,
    Problem,
)
from covey.kernels.maximum.working_set import new_working_set
from covey.model.validation import Floats, Ints
from covey.planning.long_calls import LONG, interceptions_of, interruptible, new_flag
from covey.planning.threads import Threads
from covey.planning.workspace import workspace

MAX_STEPS = 200
"""Steps of an ascent: it rarely takes more than 50."""
ASCENT_VALUES = 30
"""Values of the objective that an ascent computes, about."""
ROUGH_TOLERANCE = 1e-3
"""Tolerance of the ascents from guesses of a large team; only the best plan is made exact."""
PARALLEL = 9
"""From this many evaders on, ascents run in parallel: each takes milliseconds."""


class Ascents(NamedTuple):
    """The best plan of some ascents, and their cost."""

    value: float  # -inf where the deadline came before anything was proven
    status: int  # CONVERGED, STALLED or STEPS_USED_UP
    iterate: Iterate  # turns and working set of the plan
    starts: int  # ascents
    steps: int
    interceptions: int
    in_time: bool  # whether no ascent was left out or ended early because of the deadline

    def joined(self, other: Ascents) -> Ascents:
        """Return the better plan, this plan among equals, and the cost of both."""
        found = other.starts > 0 and is_better(other.value, self.value)
        best = other if found else self
        return Ascents(
            *best[:3],
            starts=self.starts + other.starts,
            steps=self.steps + other.steps,
            interceptions=self.interceptions + other.interceptions,
            in_time=self.in_time and other.in_time,
        )


NONE = Ascents(-math.inf, CONVERGED, Iterate(np.empty(0), new_working_set(0)), 0, 0, 0, True)
"""What no ascent has found."""


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
    deadline
        By `time.perf_counter`, when the search ends with what it has; inf: none. The first turns
        are always evaluated.
    """

    def __init__(
        self, problem: Problem, tolerance: float, uniforms: Floats, deadline: float
    ) -> None:
        self._problem, self._tolerance, self._uniforms = problem, tolerance, uniforms
        self._deadline = deadline
        self._size, self._total = len(problem.evaders), problem.objective.total
        self._work = ASCENT_VALUES * interceptions_of(problem.objective, self._size)
        self._elite = new_elite(self._size)
        self.is_rough = self._size >= FEWEST_WALKING and not (
            self._total or problem.objective.expected
        )

    @property
    def elite(self) -> list[Floats]:
        """Turns of the best plans so far, up to three of different values, the best first."""
        values, turns = self._elite
        return [turns[k] for k in range(len(values)) if values[k] > -math.inf]

    def refine(self, iterate: Iterate, value: float = -math.inf) -> Ascents:
        """Ascend from a plan, which is overwritten; `value` is what its turns guarantee, if known.

        The result never guarantees less.
        """
        known = iterate.working_set.used[0] > 0
        radius = RADIUS_WARM if known else RADIUS_UNKNOWN_SET
        options = Options(radius, self._tolerance, MAX_STEPS)

        def ascend(scratch: Workspace) -> tuple[float, int, int, int]:
            return refine(self._problem, self._uniforms, 0, options, value, iterate, scratch)

        found = interruptible(ascend, self._size, self._total, self._work, self._deadline)
        ascents = _ascents(found, iterate, 1)
        self._insert(ascents)
        return ascents._replace(in_time=time.perf_counter() <= self._deadline)

    def run(self, best: Ascents, count: int) -> Ascents:
        """Ascend from `count` guesses; return the best with `best`, this plan among equals."""
        long = count * self._work > LONG or (count > 1 and self._size >= PARALLEL)
        if long or self._deadline < math.inf:
            return self._run_parallel(best, count)
        return best.joined(self._ascend(0, count))

    def _run_parallel(self, best: Ascents, count: int) -> Ascents:
        """Ascend from `count` guesses, a batch at a time in parallel."""
        stop = new_flag()

        def ascend(guess: int) -> Ascents:
            needless = stop[0] != GO_ON and (guess > 0 or best.starts > 0)
            return NONE if needless else self._ascend(guess, 1, stop)

        with Threads(min(BATCH, os.cpu_count() or 1)) as threads:
            for first in range(0, count, BATCH):
                batch = [partial(ascend, k) for k in range(first, min(first + BATCH, count))]
                for ascents in threads.run(batch, stop, self._deadline):
                    self._insert(ascents)
                    best = best.joined(ascents)
                if stop[0] != GO_ON:
                    return best._replace(in_time=False)
        return best

    def _ascend(self, first: int, count: int, stop: Ints | None = None) -> Ascents:
        """Ascend from `count` guesses, from guess number `first` on, in this thread."""
        iterate = Iterate(np.zeros(self._size), new_working_set(self._size))
        guesses = Guesses(self._uniforms, self._elite, first, count)
        tolerance = max(self._tolerance, ROUGH_TOLERANCE) if self.is_rough else self._tolerance
        options = Options(RADIUS_RANDOM, tolerance, MAX_STEPS)
        scratch = workspace(self._size, self._total, stop)
        found = multistart(self._problem, guesses, options, -math.inf, iterate, scratch)
        return _ascents(found, iterate, count)

    def _insert(self, ascents: Ascents) -> None:
        """Insert a plan into the elite, which later guesses vary."""
        if ascents.value > -math.inf:
            insert(self._elite, ascents.value, ascents.iterate.turns)


def _ascents(found: tuple[float, int, int, int], iterate: Iterate, starts: int) -> Ascents:
    value, status, steps, interceptions = found
    return Ascents(value, status, iterate, starts, steps, interceptions, in_time=True)
