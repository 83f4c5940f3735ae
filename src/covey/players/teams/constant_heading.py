"""The constant-heading game of the earlier paper, in which evaders turn at once."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats, whole_number
from covey.planning.open_loop import DEFAULT_STARTS
from covey.players.teams.open_loop import IterativeOpenLoop, Replanning
from covey.players.teams.replan_interval import checked_replan_time, paced
from covey.simulation import Situation, TeamPolicy


@dataclass(frozen=True)
class ConstantHeading:
    """Plan as if every evader turned at once, and as if the pursuer were at the disk's centre.

    Iterative open loop in the special case r = 0, ω = ∞ of eq. (6), which is the game that the
    paper extends (its reference [11]). The evaders turn to the headings of that plan the shorter
    way, as fast as they can. Where they do turn at once, and see the pursuer, it is
    `IterativeOpenLoop`; elsewhere nothing is guaranteed.

    Parameters
    ----------
    starts, restarts
        Starts of the search; see `IterativeOpenLoop`.
    replan_time
        Least time between two plans, >= 0; 0 plans at every update. A capture brings a new plan at
        once.

    References
    ----------
    S.-Y. Liu, Z. Zhou, C. Tomlin and J. K. Hedrick, "Evasion as a Team against a Faster Pursuer",
    ACC 2013.
    """

    starts: int = DEFAULT_STARTS
    restarts: int = 8
    replan_time: float = 0.0

    def __post_init__(self) -> None:
        """Check the fields."""
        whole_number("ConstantHeading.starts", self.starts, low=1)
        whole_number("ConstantHeading.restarts", self.restarts, low=0)
        checked_replan_time(self)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "constant-heading", **asdict(self)}

    def start(self, seed: int) -> TeamPolicy:
        """Return the policy of one game."""
        strategy = IterativeOpenLoop(self.starts, self.restarts)
        plan = Replanning(strategy, seed, same_game=False)  # the simplified one is ever new

        def turns(situation: Situation) -> Floats:
            return plan(_simplified(situation))

        return paced(turns, self.replan_time)


def _simplified(situation: Situation) -> Situation:
    """The same moment of the earlier paper's game."""
    team, disk = situation.team, situation.disk
    return replace(
        situation,
        team=Team(team.positions, team.headings, team.speeds, math.inf),
        disk=PursuerDisk(disk.center, 0.0, disk.speed, disk.capture_radius),
    )
