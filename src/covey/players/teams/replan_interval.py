"""When a team plans again: at every update, or after an interval; always after a capture."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, ClassVar

import numpy.typing as npt

from covey.model.validation import number
from covey.simulation import Situation, TeamPolicy

_ROUNDING = 1e-9
"""Relative: a sum of update times may be smaller by this than the interval it stands for."""


class ReplanningTeam(ABC):
    """A strategy that plans anew, at most once in `replan_time` between captures.

    Its parameters are the fields of the dataclass that a subclass is.
    """

    file_name: ClassVar[str]
    replan_time: float

    def __post_init__(self) -> None:
        """Raise InputError unless `replan_time` is a finite number >= 0."""
        number(f"{type(self).__name__}.replan_time", self.replan_time, low=0.0)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": self.file_name, **vars(self)}

    def start(self, seed: int) -> TeamPolicy:
        """Return the policy of one game."""
        return at_interval(self.planner(seed), self.replan_time)

    @abstractmethod
    def planner(self, seed: int) -> TeamPolicy:
        """Return the function that makes the plans of one game."""


def minimum_wait(replan_time: float) -> float:
    """Return the least time from one plan to the next update that brings a new plan."""
    return replan_time * (1.0 - _ROUNDING)


def at_interval(planner: TeamPolicy, replan_time: float) -> TeamPolicy:
    """Return a policy that calls `planner` at the interval, and else keeps the announced plan.

    `planner` is also called at the first update and after every capture.
    """
    wait = minimum_wait(replan_time)
    planned_at = 0.0
    living: tuple[int, ...] = ()

    def turns(situation: Situation) -> npt.ArrayLike:
        nonlocal planned_at, living
        if situation.evaders == living and situation.time - planned_at < wait:
            return situation.turns
        planned_at, living = situation.time, situation.evaders
        return planner(situation)

    return turns
