"""Teams that plan nothing: hold course, or fly straight away from the pursuer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from covey.model.angles import away_from, wrap_angle
from covey.model.validation import Floats
from covey.players.teams.replan_interval import checked_replan_time, paced
from covey.simulation import Situation, TeamPolicy


@dataclass(frozen=True)
class HoldCourse:
    """Never turn: what a team does that knows of no pursuer."""

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "hold-course"}

    def start(self, seed: int) -> TeamPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return lambda situation: np.zeros(len(situation.evaders))


@dataclass(frozen=True)
class StraightAway:
    """Turn away from the centre of the disk, each evader on its own.

    The best that a single evader can do that turns at once: pure evasion.

    Parameters
    ----------
    replan_time
        Least time between two plans, >= 0; 0 plans at every update. A capture brings a new plan at
        once.
    """

    replan_time: float = 0.0

    def __post_init__(self) -> None:
        """Check the field."""
        checked_replan_time(self)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "straight-away", **asdict(self)}

    def start(self, seed: int) -> TeamPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return paced(_away, self.replan_time)


def _away(situation: Situation) -> Floats:
    """Signed turns (n,); an evader at the centre keeps its heading, as all lead away from there."""
    team, center = situation.team, situation.disk.center
    leaves = (team.positions != center).any(axis=1)
    away = np.where(leaves, away_from(center, team.positions), team.headings)
    return wrap_angle(away - team.headings)
