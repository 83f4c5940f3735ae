"""The search for a plan: ascents from many starts, in one go or side by side on several cores."""

from __future__ import annotations

import os
import time
from concurrent.futures import ThreadPoolExecutor

from covey.kernels.maximum.initial_guesses import BATCH, enter, make_elite
from covey.kernels.maximum.multistart import (
    Found,
    continue_plan,
    follow_one,
    is_better,
    search_all,
)
from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.sqp import STEPS_USED_UP
from covey.kernels.maximum.working_set import Columns
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.planning.guarantee import pursuit_of

MOST_STEPS = 200
START_STEPS = 50
"""Steps of an ascent while other starts wait: one in a hundred takes more, and gains little."""


class Multistart:
    """The best plan so far, and what it has cost to find it.

    Attributes
    ----------
    best : Found or None
    draws : Columns
        The sequences of an expectation.
    done, steps, interceptions : int
        Starts that were followed, steps and interceptions that they took.
    """

    def __init__(self, team: Team, disk: PursuerDisk, aim: Aim, tolerance: float) -> None:
        self._aim, self._tolerance = aim, tolerance
        self._evaders, self._pursuit = team.as_rows(), pursuit_of(disk)
        self._elite = make_elite(len(team))
        self.best: Found | None = None
        self.draws = aim.draws
        self.done = self.steps = self.interceptions = 0

    def go_on_from(self, turns: Floats, columns: Columns) -> None:
        """Ascend from a plan, with its columns."""
        found = self._continued(turns, columns)
        self._take(found, 1)
        enter(self._elite, len(turns), found.value, found.turns)

    def finish(self) -> None:
        """Go on with the best plan if its steps were used up while other starts waited."""
        if self.best is not None and self.best.ended == STEPS_USED_UP:
            found = self._continued(self.best.turns, self.best.columns)
            self._take(found, 0)
            self.best = found  # never worse, and ended otherwise

    def _continued(self, turns: Floats, columns: Columns) -> Found:
        return continue_plan(
            self._evaders, self._pursuit, self._aim, turns, columns, self._tolerance, MOST_STEPS
        )

    def follow_all(self, noise: Floats, starts: int) -> None:
        """Follow all starts in one go."""
        if starts > 0:
            found = search_all(
                self._evaders,
                self._pursuit,
                self._aim,
                noise,
                starts,
                self._tolerance,
                START_STEPS,
                self._elite,
            )
            self._take(found, starts)

    def follow_side_by_side(self, noise: Floats, starts: int, late: float) -> bool:
        """Follow the starts of a batch on several cores; return whether all were in time."""

        def follow(start: int) -> Found | None:
            if time.perf_counter() > late and (start > 0 or self.done > 0):
                return None
            return follow_one(
                self._evaders,
                self._pursuit,
                self._aim,
                noise,
                start,
                self._tolerance,
                START_STEPS,
                self._elite,
            )

        with ThreadPoolExecutor(min(BATCH, os.cpu_count() or 1)) as crew:
            for first in range(0, starts, BATCH):
                batch = list(crew.map(follow, range(first, min(first + BATCH, starts))))
                for found in batch:
                    if found is not None:
                        self._take(found, 1)
                        enter(self._elite, len(self._evaders), found.value, found.turns)
                if None in batch:
                    return False
        return True

    def _take(self, found: Found, starts: int) -> None:
        self.done += starts
        self.steps += found.cost.steps
        self.interceptions += found.cost.interceptions
        if self.best is None or is_better(found.value, self.best.value):
            self.best = found
