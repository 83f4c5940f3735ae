"""The constant-heading game of the earlier paper, in which evaders turn at once."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.players.teams.open_loop import Replanning, SearchingTeam
from covey.simulation import Situation, TeamPolicy


@dataclass(frozen=True)
class ConstantHeading(SearchingTeam):
    """Plan as if every evader turned at once, and as if the pursuer were at the disk's centre.

    Iterative open loop in the special case r = 0, ω = ∞ of eq. (6): the game that the paper extends
    (its reference [11]). The evaders turn to the headings of that plan the shorter way, as fast as
    they can. If they do turn at once, and see the pursuer, this is `IterativeOpenLoop`. In all
    other games nothing is guaranteed.

    Parameters
    ----------
    starts, restarts
        Starts of the search; see `IterativeOpenLoop`.
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture.

    References
    ----------
    S.-Y. Liu, Z. Zhou, C. Tomlin and J. K. Hedrick, "Evasion as a Team against a Faster Pursuer",
    ACC 2013.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.ConstantHeading(), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.38
    """

    file_name = "constant-heading"

    def planner(self, seed: int) -> TeamPolicy:
        """Return the function that makes the plans of one game."""
        # Each simplified situation begins a game of its own: the evaders don't turn at once.
        plan = Replanning(self, seed, same_game=False)

        def turns(situation: Situation) -> Floats:
            return plan(_simplified(situation))

        return turns


def _simplified(situation: Situation) -> Situation:
    """The same situation in the earlier paper's game."""
    team, disk = situation.team, situation.disk
    return replace(
        situation,
        team=Team(team.positions, team.headings, team.speeds, math.inf),
        disk=PursuerDisk(disk.center, 0.0, disk.speed, disk.capture_radius),
    )
