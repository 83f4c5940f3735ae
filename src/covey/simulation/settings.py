"""How a game is played: sensing, time between updates, seed, limit, objective; checked once."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from covey.kernels.play.rules import Rules, State, initial_state
from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.model.validation import Floats, choice, number, whole_number
from covey.planning.compiled_objective import checked_objective

SENSING = ("hidden", "visible")


@dataclass(frozen=True)
class Settings:
    """How a game is played.

    Parameters
    ----------
    sensing
        "hidden" or "visible".
    update_time
        Δt > 0.
    seed
        Whole number >= 0.
    time_limit
        Time at which a game is stopped; inf: never.
    objective
        What the team maximises and the pursuer minimises.

    Raises
    ------
    InputError
        If a parameter can't be used.
    """

    sensing: str
    update_time: float
    seed: int
    time_limit: float = math.inf
    objective: Objective = LastCapture()  # noqa: RUF009 frozen

    def __post_init__(self) -> None:
        """Check every field."""
        choice("sensing", self.sensing, SENSING)
        number("update_time", self.update_time, low=0.0, strictly=True)
        whole_number("seed", self.seed, low=0)
        if self.time_limit != math.inf:
            number("time_limit", self.time_limit, low=0.0, strictly=True)
        checked_objective(self.objective)

    def rules(self, disk: PursuerDisk, *, has_position: bool = False) -> Rules:
        """Return the rules for the kernels; `has_position` as there."""
        return Rules(
            disk.speed,
            disk.capture_radius,
            self.sensing == "hidden",
            float(self.update_time),
            float(self.time_limit),
            has_position,
        )


class GameSetup(NamedTuple):
    """A game before it is played."""

    team: Team
    disk: PursuerDisk
    settings: Settings
    strategies: Mapping[str, Mapping[str, Any]]  # descriptions of both sides
    position: Floats | None = None  # (2,) of the pursuer; None: the rules know it as a disk only


def first_state(team: Team, disk: PursuerDisk, position: Floats | None = None) -> State:
    """Return the state of a game at time 0; `position` (2,) is the pursuer's, if it has one."""
    x, y = disk.center.tolist()
    state = initial_state(team.as_rows(), x, y, disk.radius)
    return state if position is None else state._replace(pursuer=np.array([*position, 0.0]))
