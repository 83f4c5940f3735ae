"""Teams that plan nothing: hold course, or fly straight away from the pursuer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.model.angles import away_from, wrap_angle
from covey.model.validation import Floats
from covey.players.teams.replan_interval import ReplanningTeam
from covey.simulation import Situation, TeamPolicy


@dataclass(frozen=True)
class HoldCourse:
    """Never turn, as a team that knows of no pursuer."""

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "hold-course"}

    def start(self, seed: int) -> TeamPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return lambda situation: np.zeros(len(situation.evaders))


@dataclass(frozen=True)
class StraightAway(ReplanningTeam):
    """Turn away from the centre of the disk, each evader on its own.

    Pure evasion: the best flight of a single evader that turns at once.

    Parameters
    ----------
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture.
    """

    file_name = "straight-away"
    replan_time: float = 0.0

    def planner(self, seed: int) -> TeamPolicy:  # noqa: ARG002 nothing is drawn
        """Return the function that makes the plans of one game."""
        return _away


def _away(situation: Situation) -> Floats:
    """Signed turns (n,); an evader at the centre keeps its heading."""
    team, center = situation.team, situation.disk.center
    leaves = (team.positions != center).any(axis=1)
    away = np.where(leaves, away_from(center, team.positions), team.headings)
    return wrap_angle(away - team.headings)
