"""When a team plans again: at every update, or only after some time; always after a capture."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from covey.model.validation import number
from covey.simulation import Situation, TeamPolicy

_ROUNDING = 1e-9
"""Relative: a sum of update times may fall this short of the time that it stands for."""


def checked_replan_time(strategy: Any) -> None:
    """Raise InputError unless the strategy's `replan_time` is a finite number >= 0."""
    number(f"{type(strategy).__name__}.replan_time", strategy.replan_time, low=0.0)


def least_wait(replan_time: float) -> float:
    """Return by how much later than the last plan an update must be to bring a new one."""
    return replan_time * (1.0 - _ROUNDING)


def paced(plan: TeamPolicy, replan_time: float) -> TeamPolicy:
    """Return a policy that asks `plan` at its pace, and flies on with the announced plan between.

    The first update is a time to plan, and so is every capture.
    """
    wait = least_wait(replan_time)
    planned = 0.0
    living: tuple[int, ...] = ()

    def turns(situation: Situation) -> npt.ArrayLike:
        nonlocal planned, living
        if situation.evaders == living and situation.time - planned < wait:
            return situation.turns
        planned, living = situation.time, situation.evaders
        return plan(situation)

    return turns
