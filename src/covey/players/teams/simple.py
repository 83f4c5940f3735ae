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
    """Never turn, as a team that knows of no pursuer.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.HoldCourse(), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.15
    """

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

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.StraightAway(), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.09
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
