"""Keep away from the pursuer: the largest least distance, after Abramyants and others."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from covey.model import PursuerDisk
from covey.model.validation import Floats
from covey.players.teams.lookahead import Score, best_turn, captured_at, first_threat, places_at
from covey.players.teams.replan_interval import checked_replan_time, paced
from covey.simulation import Situation, TeamPolicy

_MOMENTS = np.linspace(0.0, 1.0, 17)


@dataclass(frozen=True)
class LargestDistance:
    """Each evader makes its least distance to the pursuer as large as it can.

    In the reference, the paper's [2], the evaders maximise the least distance over time to a
    pursuer of limited sensing range. Here the pursuer is faster and gets everybody in the end, so
    the aim is adapted to the time until the next capture: the pursuer is taken to fly straight to
    the evader that it could capture first, from where in the disk that one is nearest. Each of the
    others maximises its least distance to this flight, at 17 moments of it. Where that is what it
    is now, because the pursuer leaves it behind, and for the target itself, the turn counts after
    which it could be captured latest.

    Parameters
    ----------
    replan_time
        Least time between two plans, >= 0; 0 plans at every update. A capture brings a new plan at
        once.

    References
    ----------
    T. G. Abramyants, M. N. Ivanov, E. P. Maslov and V. P. Yakhno, "A detection evasion problem",
    Automation and Remote Control 65 (2004).
    """

    replan_time: float = 0.0

    def __post_init__(self) -> None:
        """Check the field."""
        checked_replan_time(self)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "largest-distance", **asdict(self)}

    def start(self, seed: int) -> TeamPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return paced(_keep_away, self.replan_time)


def _keep_away(situation: Situation) -> Floats:
    threat, disk = first_threat(situation), situation.disk
    goal = threat.places[threat.row]
    times = threat.time * _MOMENTS
    flight = disk.towards(goal, disk.radius + disk.speed * times)
    there = PursuerDisk(goal, 0.0, disk.speed, disk.capture_radius)

    def latest_capture(paths: Floats) -> tuple[Floats, Floats]:
        return np.zeros(len(paths)), captured_at(paths, disk)

    def largest_distance(paths: Floats) -> tuple[Floats, Floats]:
        off = places_at(paths, times) - flight[:, None]
        least = np.hypot(off[:, :, 0], off[:, :, 1]).min(axis=0)
        return least, captured_at(paths, there, threat.time)

    scores: list[Score] = [largest_distance] * len(situation.evaders)
    scores[threat.row] = latest_capture
    return np.array([best_turn(situation, row, score) for row, score in enumerate(scores)])
