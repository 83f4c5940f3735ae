"""Each for itself: the smallest domain of danger, after Liu and Hedrick."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from covey.model.angles import unit_vectors
from covey.model.validation import Floats
from covey.players.teams.lookahead import best_turn, captured_at, first_threat, positions_at
from covey.players.teams.replan_interval import ReplanningTeam
from covey.simulation import Situation, TeamPolicy

_POINTS = 256


@dataclass(frozen=True)
class SmallestDanger(ReplanningTeam):
    """Each evader minimises the part of the disk from which it is the pursuer's nearest evader.

    In the reference, the paper's [4], each evader minimises the probability that it is the evader
    nearest to a hidden pursuer. Its domain of danger, its Voronoi cell, holds the positions of the
    pursuer for which it is the nearest. Here the team knows a disk. The domains are taken at the
    earliest time at which the pursuer could capture somebody, with the other evaders where their
    announced plans take them. The pursuer is equally likely to be anywhere in the disk, grown until
    then, and the evader minimises its share of that disk. Where several turns leave the same share,
    zero for example, the evader takes the turn with the latest earliest capture.

    Parameters
    ----------
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture.

    References
    ----------
    S.-Y. Liu and J. K. Hedrick, "The application of domain of danger in autonomous agent team and
    its effect on exploration efficiency", ACC 2011; the domain of danger is that of W. D. Hamilton,
    "Geometry for the selfish herd", Journal of Theoretical Biology 31 (1971).

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, evaders=covey.SmallestDanger(), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.16
    """

    file_name = "smallest-danger"
    replan_time: float = 0.0

    def planner(self, seed: int) -> TeamPolicy:  # noqa: ARG002 nothing is drawn
        """Return the function that makes the plans of one game."""
        return _each_for_itself


def _each_for_itself(situation: Situation) -> Floats:
    threat, disk = first_threat(situation), situation.disk
    points = disk.center + (disk.radius + disk.speed * threat.time) * _SUNFLOWER
    gaps = _squares(threat.positions, points)

    def turn(row: int) -> float:
        others = np.delete(gaps, row, axis=0).min(axis=0, initial=math.inf)

        def score(paths: Floats) -> tuple[Floats, Floats]:
            own = _squares(positions_at(paths, np.array([threat.time]))[0], points)
            return -(own < others).mean(axis=1), captured_at(paths, disk)

        return best_turn(situation, row, score)

    return np.array([turn(row) for row in range(len(situation.evaders))])


def _squares(positions: Floats, points: Floats) -> Floats:
    """Squared distances (K, P) of positions (K, 2) and points (P, 2)."""
    x, y = (positions[:, None, axis] - points[:, axis] for axis in (0, 1))
    squares: Floats = x * x + y * y
    return squares


def _sunflower(count: int) -> Floats:
    """Points (count, 2) spread evenly over the unit disk (Vogel 1979)."""
    rank = np.arange(count) + 0.5
    angles = rank * math.pi * (3.0 - math.sqrt(5.0))
    radii = np.sqrt(rank / count)
    return radii[:, None] * unit_vectors(angles)


_SUNFLOWER = _sunflower(_POINTS)
