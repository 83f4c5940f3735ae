"""Keep away from the pursuer: the largest least distance, after Abramyants and others."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from covey.model import PursuerDisk
from covey.model.validation import Floats
from covey.players.teams.lookahead import (
    PathScore,
    best_turn,
    captured_at,
    first_threat,
    positions_at,
)
from covey.players.teams.replan_interval import ReplanningTeam
from covey.simulation import Situation, TeamPolicy

_SHARES = np.linspace(0.0, 1.0, 17)


@dataclass(frozen=True)
class LargestDistance(ReplanningTeam):
    """Each evader makes its least distance to the pursuer as large as it can.

    In the reference, the paper's [2], the evaders maximise the least distance over time to a
    pursuer of limited sensing range. Here the pursuer is faster and captures everybody in the end,
    so the objective is limited to the time until the next capture. The pursuer is assumed to fly
    straight to the evader that it could capture first, from the disk's point nearest to that
    capture. Every other evader maximises its least distance to this flight, at 17 times. If the
    distance only grows, its least value is the same for all turns; then the evader maximises its
    earliest capture time instead, from the capture on. The target maximises its own.

    Parameters
    ----------
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture.

    References
    ----------
    T. G. Abramyants, M. N. Ivanov, E. P. Maslov and V. P. Yakhno, "A detection evasion problem",
    Automation and Remote Control 65 (2004).

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.LargestDistance(), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.51
    """

    file_name = "largest-distance"
    replan_time: float = 0.0

    def planner(self, seed: int) -> TeamPolicy:  # noqa: ARG002 nothing is drawn
        """Return the function that makes the plans of one game."""
        return _keep_away


def _keep_away(situation: Situation) -> Floats:
    threat, disk = first_threat(situation), situation.disk
    goal = threat.positions[threat.row]
    times = threat.time * _SHARES
    flight = disk.towards(goal, disk.radius + disk.speed * times)
    there = PursuerDisk(goal, 0.0, disk.speed, disk.capture_radius)

    def latest_capture(paths: Floats) -> tuple[Floats, Floats]:
        return np.zeros(len(paths)), captured_at(paths, disk)

    def largest_distance(paths: Floats) -> tuple[Floats, Floats]:
        off = positions_at(paths, times) - flight[:, None]
        least = np.hypot(off[:, :, 0], off[:, :, 1]).min(axis=0)
        return least, captured_at(paths, there, threat.time)

    scores: list[PathScore] = [largest_distance] * len(situation.evaders)
    scores[threat.row] = latest_capture
    return np.array([best_turn(situation, row, score) for row, score in enumerate(scores)])
