"""Teams that plan in open loop: once, or again at every update (section IV.C of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.kernels.arrays import LARGEST_TABLE, Workspace
from covey.kernels.maximum.objective import elapsed_value
from covey.kernels.maximum.problem import Problem
from covey.kernels.play.policy import ReplanOptions, TeamMemory, forget, replan
from covey.model.validation import MOST_STARTS, Floats, whole_number
from covey.planning import Plan
from covey.planning.border import pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.long_calls import interceptions_of, interruptible
from covey.planning.multistart import MAX_STEPS
from covey.planning.open_loop import (
    DEFAULT_STARTS,
    DEFAULT_TOLERANCE,
    first_plan,
    guess_uniforms,
    working_set_of,
)
from covey.players.teams.replan_interval import ReplanningTeam, minimum_wait
from covey.simulation import Situation, TeamPolicy
from covey.simulation.strategy import in_any_frame

UPDATE_VALUES = 4
"""Values of the objective that an update computes, about."""
REPLAN_TOLERANCE = 1e-7
"""An update stops at this relative predicted gain; the next update continues from there."""


@dataclass(frozen=True)
class OpenLoop:
    """Plan once, and fly that plan to the end (section IV.B of the paper).

    Parameters
    ----------
    starts
        Starts of the search for the plan; see `covey.plan`. A team of eighteen or more follows no
        more than `covey.plan` does by default.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.OpenLoop())
    >>> round(game.guarantee, 3), round(game.survival_time, 3)
    (3.365, 3.365)
    """

    starts: int = DEFAULT_STARTS

    def __post_init__(self) -> None:
        """Check the field."""
        whole_number("OpenLoop.starts", self.starts, low=1, high=MOST_STARTS)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "open-loop", "starts": self.starts}

    def compiled(self) -> ReplanOptions:
        """Return how the team plans in a compiled game."""
        return ReplanOptions(False, 0.0, 0, DEFAULT_TOLERANCE, MAX_STEPS)

    def start(self, seed: int) -> TeamPolicy:
        """Return the policy of one game."""
        begun = False

        def turns(situation: Situation) -> Floats:
            nonlocal begun
            if begun:
                return situation.turns
            begun = True
            return first_plan(
                situation.team, situation.disk, situation.objective, seed, self.starts
            ).turns

        return in_any_frame(turns)


@dataclass(frozen=True)
class SearchingTeam(ReplanningTeam):
    """A team that searches for its plans; the parameters are those of `IterativeOpenLoop`."""

    starts: int = DEFAULT_STARTS
    restarts: int = 8
    replan_time: float = 0.0

    def __post_init__(self) -> None:
        """Check the fields."""
        name = type(self).__name__
        whole_number(f"{name}.starts", self.starts, low=1, high=MOST_STARTS)
        whole_number(f"{name}.restarts", self.restarts, low=0, high=MOST_STARTS)
        super().__post_init__()

    def start(self, seed: int) -> TeamPolicy:
        """Return the policy of one game."""
        return in_any_frame(super().start(seed))

    def compiled(self) -> ReplanOptions:
        """Return how the team plans in a compiled game."""
        interval = minimum_wait(self.replan_time)
        return ReplanOptions(True, interval, self.restarts, REPLAN_TOLERANCE, MAX_STEPS)


@dataclass(frozen=True)
class IterativeOpenLoop(SearchingTeam):
    """Plan again and again, from the present state: the paper's iOL (section IV.C).

    The first start of each search is the plan that is being flown. So the team never survives less
    than its first plan guaranteed; where the game is about the sum of survival times, that sum is
    never less.

    Parameters
    ----------
    starts
        Starts of the search for the first plan; see `covey.plan`. A team of eighteen or more
        follows no more than `covey.plan` does by default.
    restarts
        Other starts of the search after a capture, when the game is a new one. A team of eighteen
        or more follows none.
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> team_strategy = covey.IterativeOpenLoop(replan_time=0.1)
    >>> game = covey.simulate(team, disk, evaders=team_strategy)
    >>> game.survival_time >= game.guarantee
    True
    """

    file_name = "iterative-open-loop"

    def planner(self, seed: int) -> TeamPolicy:
        """Return the function that makes the plans of one game."""
        return Replanning(self, seed)


class Replanning:
    """The policy of an iterative open-loop team in one game, and its memory.

    Parameters
    ----------
    strategy, seed
        The strategy, and the seed of the game.
    same_game
        Whether all situations are of one game that goes by the rules. Then the value of a plan
        falls by at most the time that passes, and this lower bound saves work.
    """

    def __init__(self, strategy: SearchingTeam, seed: int, *, same_game: bool = True) -> None:
        self._strategy, self._seed, self._same_game = strategy, seed, same_game
        self._living: tuple[int, ...] = ()

    def __call__(self, situation: Situation) -> Floats:
        """Return the first plan, or the last one improved."""
        if not self._living:
            return self._begin(situation)
        memory, options, living = self._memory, self._strategy.compiled(), len(self._living)
        elapsed = situation.time - memory.last[0]
        spent = elapsed_value(elapsed, living, memory.objective.total)
        restarts = 0
        for row, i in enumerate(self._living):
            if i not in situation.evaders:
                forget(memory, living, row)
                self._living = tuple(j for j in self._living if j != i)
                restarts = options.restarts
                break
        turns = situation.turns.copy()
        problem = Problem(situation.team.as_rows(), pursuit_of(situation.disk), memory.objective)

        def improve(scratch: Workspace) -> None:
            replan(problem, options, memory, spent, restarts, turns, scratch)

        # The next call may come from another thread, which has workspaces of its own.
        work = UPDATE_VALUES * interceptions_of(memory.objective, living)
        interruptible(improve, self._size, memory.objective.total, work)
        memory.last[0] = situation.time
        if not self._same_game:
            memory.last[1] = -math.inf
        return turns

    def _begin(self, situation: Situation) -> Floats:
        first = first_plan(
            situation.team,
            situation.disk,
            situation.objective,
            self._seed,
            self._strategy.starts,
        )
        self._living = situation.evaders
        self._memory = first_memory(first, self._seed, self._strategy.restarts)
        self._memory.last[0] = situation.time
        self._size = len(first.turns)
        return np.array(first.turns)


def first_memory(first: Plan, seed: int, restarts: int) -> TeamMemory:
    """Return what a team remembers at time 0, with its first plan made."""
    n = len(first.turns)
    value = first.survival_time if n > LARGEST_TABLE else -math.inf  # it takes long to find again
    uniforms, last = guess_uniforms(seed, restarts, n), np.array([0.0, value])
    return TeamMemory(working_set_of(first), uniforms, last, compiled_objective(first.objective, n))
