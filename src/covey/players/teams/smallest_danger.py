"""Each for itself: the smallest domain of danger, after Liu and Hedrick."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from covey.model.angles import unit_vectors
from covey.model.validation import Floats
from covey.players.teams.lookahead import best_turn, captured_at, first_threat, places_at
from covey.players.teams.replan_interval import checked_replan_time, paced
from covey.simulation import Situation, TeamPolicy

_POINTS = 256


@dataclass(frozen=True)
class SmallestDanger:
    """Each evader makes the part of the disk small in which it is the one nearest to the pursuer.

    In the reference, the paper's [4], each evader makes its own chance small of being the nearest
    to a hidden pursuer. Its domain of danger, the places from where it would be, is its Voronoi
    cell. Here the team knows a disk, so the aim is adapted: at the time at which the pursuer could
    first capture somebody, it is anywhere in the disk that has grown until then, each place as
    likely as another, and the others are where their announced plans take them. The evader makes
    its share of that disk small. Where turns leave the same share, none of it for example, the turn
    counts after which it could be captured latest.

    Parameters
    ----------
    replan_time
        Least time between two plans, >= 0; 0 plans at every update. A capture brings a new plan at
        once.

    References
    ----------
    S.-Y. Liu and J. K. Hedrick, "The application of domain of danger in autonomous agent team and
    its effect on exploration efficiency", ACC 2011; the domain of danger is that of W. D. Hamilton,
    "Geometry for the selfish herd", Journal of Theoretical Biology 31 (1971).
    """

    replan_time: float = 0.0

    def __post_init__(self) -> None:
        """Check the field."""
        checked_replan_time(self)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "smallest-danger", **asdict(self)}

    def start(self, seed: int) -> TeamPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return paced(_each_for_itself, self.replan_time)


def _each_for_itself(situation: Situation) -> Floats:
    threat, disk = first_threat(situation), situation.disk
    points = disk.center + (disk.radius + disk.speed * threat.time) * _SUNFLOWER
    gaps = _squares(threat.places, points)

    def turn(row: int) -> float:
        others = np.delete(gaps, row, axis=0).min(axis=0, initial=math.inf)

        def score(paths: Floats) -> tuple[Floats, Floats]:
            own = _squares(places_at(paths, np.array([threat.time]))[0], points)
            return -(own < others).mean(axis=1), captured_at(paths, disk)

        return best_turn(situation, row, score)

    return np.array([turn(row) for row in range(len(situation.evaders))])


def _squares(places: Floats, points: Floats) -> Floats:
    """Squared distances (K, P) of places (K, 2) and points (P, 2)."""
    x, y = (places[:, None, axis] - points[:, axis] for axis in (0, 1))
    squares: Floats = x * x + y * y
    return squares


def _sunflower(count: int) -> Floats:
    """Points (count, 2) spread evenly over the unit disk (Vogel 1979)."""
    rank = np.arange(count) + 0.5
    angles = rank * math.pi * (3.0 - math.sqrt(5.0))
    radii = np.sqrt(rank / count)
    return radii[:, None] * unit_vectors(angles)


_SUNFLOWER = _sunflower(_POINTS)
