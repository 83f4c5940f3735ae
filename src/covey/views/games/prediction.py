"""The captures that a plan must expect, along the sequence that captures the team earliest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats, Ints
from covey.simulation.expected_captures import expected_captures
from covey.views.games.flight import path
from covey.views.games.snapshot import Moment


@dataclass(frozen=True, eq=False)
class Prediction:
    """Captures in their order, and what is flown until then.

    Attributes
    ----------
    evaders, times, points : numpy.ndarray
        (M,) who, (M,) when, from now on, and (M, 2) where.
    paths : tuple of numpy.ndarray
        For each one the points (K, 2) of its path up to there.
    pursuer : numpy.ndarray
        (M + 1, 2) the pursuer's path: from the place in the disk that is the best for it, through
        the capture points.
    """

    evaders: Ints
    times: Floats
    points: Floats
    paths: tuple[Floats, ...]
    pursuer: Floats


def predict(team: Team, disk: PursuerDisk, turns: Floats, sequence: Ints) -> Prediction:
    """Captures of the evaders in `sequence`, which may leave some out, who are not predicted."""
    times = expected_captures(team, disk, turns, sequence)
    paths = tuple(
        path(team, turns, evader, time)
        for evader, time in zip(sequence.tolist(), times.tolist(), strict=True)
    )
    points = np.array([points[-1] for points in paths]).reshape(-1, 2)
    return Prediction(sequence, times, points, paths, _pursuer_path(disk, points))


def predicted(moment: Moment) -> Prediction:
    """What the plan that is flown at a moment of a game must expect."""
    return predict(moment.team, moment.disk, moment.turns, moment.sequence)


def _pursuer_path(disk: PursuerDisk, points: Floats) -> Floats:
    if not len(points):
        return disk.center[None]
    toward = points[0] - disk.center
    distance = float(np.hypot(*toward))
    share = min(1.0, disk.radius / distance) if distance > 0.0 else 0.0
    return np.vstack([disk.center + share * toward, points])
