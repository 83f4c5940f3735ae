"""What an evader that decides for itself looks ahead to: the first capture, and its own turns."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from covey.kernels.capture.chases import earliest_captures
from covey.kernels.capture.path import PATH, sample, set_paths
from covey.model import PursuerDisk
from covey.model.validation import Floats
from covey.planning.guarantee import paths_of
from covey.simulation import Situation

_GRID = np.linspace(-1.0, 1.0, 33)
_ROUNDS, _FINER = 3, 10.0
"""Turns are tried a half turn to either side, then ever closer around the best: to 0.002."""


class Threat(NamedTuple):
    """The first capture that the pursuer could make if everybody flew on as announced."""

    row: int  # of whom
    time: float  # from now
    places: Floats  # (n, 2) of everybody at that time


def first_threat(situation: Situation) -> Threat:
    """Return the capture that the team has to expect first."""
    paths = paths_of(situation.team, situation.disk, situation.turns)
    times = captured_at(paths, situation.disk)
    row = int(times.argmin())
    return Threat(row, float(times[row]), places_at(paths, times[row : row + 1])[0])


def captured_at(paths: Floats, disk: PursuerDisk, start: float = 0.0) -> Floats:
    """Return by when a pursuer that is in `disk` at time `start` could have captured each path."""
    times = np.empty(len(paths))
    x, y = disk.center.tolist()
    earliest_captures(paths, x, y, disk.radius + disk.capture_radius, start, disk.speed, times)
    return times


def places_at(paths: Floats, times: Floats) -> Floats:
    """Return where each path is at each of the times: (T, K, 2)."""
    places = np.empty((len(times), len(paths), 2))
    sample(paths, times, places)
    return places


Score = Callable[[Floats], tuple[Floats, Floats]]
"""From paths (K, PATH) to two scores (K,) each; the second decides where the first is equal."""


def best_turn(situation: Situation, row: int, score: Score) -> float:
    """Return the signed turn in [-π, π] of the evader in `row` whose path scores highest."""
    evaders = np.repeat(situation.team.as_rows()[row : row + 1], len(_GRID), axis=0)
    paths = np.empty((len(_GRID), PATH))
    turn, width = 0.0, math.pi
    for _ in range(_ROUNDS):
        turns = np.clip(turn + width * _GRID, -math.pi, math.pi)
        set_paths(evaders, turns, situation.disk.speed, paths)
        first, second = score(paths)
        turn = float(turns[np.lexsort((second, first))[-1]])
        width /= _FINER
    return turn
