"""The look-ahead of an evader that decides for itself: the first capture, and its own turns."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from covey.kernels.capture.interception import earliest_captures
from covey.kernels.capture.path import PATH, sample, set_paths
from covey.kernels.capture.pursuit import GrowingDisk
from covey.model import PursuerDisk
from covey.model.validation import Floats
from covey.planning.border import paths_of
from covey.simulation import Situation

_GRID = np.linspace(-1.0, 1.0, 33)
_ROUNDS, _REFINEMENT = 3, 10.0
"""A grid of turns in [-π, π], refined twice by a factor of 10 around the best: to 0.002 radians."""


class Threat(NamedTuple):
    """The first capture that the pursuer could make if everybody flew on as announced."""

    row: int  # of the evader that is captured
    time: float  # from now
    positions: Floats  # (n, 2) of the living at that time


def first_threat(situation: Situation) -> Threat:
    """Return the capture that the team has to expect first."""
    paths = paths_of(situation.team, situation.disk, situation.turns)
    times = captured_at(paths, situation.disk)
    row = int(times.argmin())
    return Threat(row, float(times[row]), positions_at(paths, times[row : row + 1])[0])


def captured_at(paths: Floats, disk: PursuerDisk, begin: float = 0.0) -> Floats:
    """Return the earliest capture times (K,) of paths, for a pursuer in `disk` at time `begin`."""
    times = np.empty(len(paths))
    x, y = disk.center.tolist()
    radius = disk.radius + disk.capture_radius
    earliest_captures(paths, GrowingDisk(x, y, radius, begin, disk.speed), times)
    return times


def positions_at(paths: Floats, times: Floats) -> Floats:
    """Return the positions (T, K, 2) of K paths at T times."""
    positions = np.empty((len(times), len(paths), 2))
    sample(paths, times, positions)
    return positions


PathScore = Callable[[Floats], tuple[Floats, Floats]]
"""From paths (K, PATH) to two scores (K,) each; the second decides where the first are equal."""


def best_turn(situation: Situation, row: int, score: PathScore) -> float:
    """Return the signed turn in [-π, π] of the evader in `row` whose path scores highest."""
    evaders = np.repeat(situation.team.as_rows()[row : row + 1], len(_GRID), axis=0)
    paths = np.empty((len(_GRID), PATH))
    turn, width = 0.0, math.pi
    for _ in range(_ROUNDS):
        turns = np.clip(turn + width * _GRID, -math.pi, math.pi)
        set_paths(evaders, turns, situation.disk.speed, paths)
        first, second = score(paths)
        turn = float(turns[np.lexsort((second, first))[-1]])
        width /= _REFINEMENT
    return turn
