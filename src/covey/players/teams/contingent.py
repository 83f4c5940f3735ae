"""A team whose plan is a tree that answers captures, planned again at every update."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.kernels.contingent.scratch import new_branches
from covey.kernels.contingent.tree import answer_to
from covey.kernels.maximum.working_set import WorkingSet
from covey.model.validation import Floats, whole_number
from covey.planning.border import pursuit_of
from covey.planning.contingent import plan_contingent
from covey.planning.contingent.moment import Moment
from covey.planning.contingent.search import ascend, deepened
from covey.players.teams.replan_interval import ReplanningTeam
from covey.simulation import Situation, TeamPolicy
from covey.simulation.strategy import in_any_frame


@dataclass(frozen=True)
class Contingent(ReplanningTeam):
    """Plan turns for now and for after each capture, again and again: see `plan_contingent`.

    The plan that is being flown is where each search begins, and after a capture that is the part
    of the plan which answers the capture. So what the team was promised never falls while captures
    happen as early as they can.

    Parameters
    ----------
    depth
        Captures that each plan answers; None: all.
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.Contingent(depth=1), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.56
    """

    depth: int | None = None
    replan_time: float = 0.0

    file_name = "contingent"

    def __post_init__(self) -> None:
        """Check the fields."""
        if self.depth is not None:
            whole_number("Contingent.depth", self.depth, low=0)
        super().__post_init__()

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {key: value for key, value in super().describe().items() if value is not None}

    def start(self, seed: int) -> TeamPolicy:
        """Return the policy of one game."""
        return in_any_frame(super().start(seed))

    def planner(self, seed: int) -> Flight:
        """Return the function that makes the plans of one game."""
        return Flight(self.depth, seed)


class Flight:
    """The plans of one game: the tree that is flown, and the branches that limit it.

    Attributes
    ----------
    promise : float
        How long from now on the tree guarantees survival, if captures happen as early as they can.
    """

    promise: float

    def __init__(self, depth: int | None, seed: int) -> None:
        self._most, self._seed = depth, seed
        self._living: tuple[int, ...] = ()
        self._tree: Floats
        self._branches: WorkingSet

    def __call__(self, situation: Situation) -> Floats:
        """Return the turns of the first plan, or those of the last plan's rest, improved."""
        if not self._living:
            return self._begin(situation)
        moment = Moment(situation.team.as_rows(), pursuit_of(situation.disk))
        if situation.evaders == self._living:
            self._tree[: len(self._living)] = situation.turns
        else:
            self._answer(situation)
        n = len(self._living)
        while self._depth < (n - 1 if self._most is None else min(self._most, n - 1)):
            self._tree = deepened(moment, self._depth, self._tree)
            self._depth += 1
        found = ascend(moment, self._depth, self._tree, self._branches)
        self._tree, self.promise = found.turns, found.value
        return self._tree[:n].copy()

    def _begin(self, situation: Situation) -> Floats:
        """Make the first plan."""
        first = plan_contingent(situation.team, situation.disk, self._most, seed=self._seed)
        self._living, self._depth = situation.evaders, first.depth
        self._tree, self.promise = first.node.turns.copy(), first.survival_time
        self._branches = new_branches(len(self._living))
        return np.array(first.turns)

    def _answer(self, situation: Situation) -> None:
        """Begin the part of the tree that answers the captures since the last update."""
        for i in [i for i in self._living if i not in situation.evaders]:
            n, rank = len(self._living), self._living.index(i)
            self._living = tuple(j for j in self._living if j != i)
            if self._depth > 0:
                self._tree = answer_to(self._tree, n, rank)
                self._depth -= 1
            else:
                self._tree = situation.turns.copy()
        self._branches = new_branches(len(self._living))
