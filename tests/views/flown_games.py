"""Games to draw: one that is flown by hand, whose every position is known, and simulated ones."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from scipy.optimize import brentq

import covey
from random_games import PLACE

RATE = math.pi / 2
RADIUS = 0.25 / RATE
"""Of the circle on which evader 1 of the game by hand turns."""
FIRST_CAPTURE = 0.8


def turning_evader(time):
    """Evader 1 by hand: a quarter turn to the left, which ends at time 1, then straight."""
    angle = RATE * min(time, 1.0)
    x, y = RADIUS * math.sin(angle), 1.0 + RADIUS * (1.0 - math.cos(angle))
    return np.array([x, y + 0.25 * max(0.0, time - 1.0)])


def _second_capture():
    def gap(time):
        x, y = turning_evader(time)
        return math.hypot(x - 0.8, y) - (time - FIRST_CAPTURE)

    return brentq(gap, 1.0, 5.0, xtol=1e-15)


SECOND_CAPTURE = _second_capture()


@cache
def game_by_hand():
    """Evader 0 flees to the right and is captured at (0.8, 0), evader 1 turns. Three rows."""
    end = turning_evader(SECOND_CAPTURE)
    captured = np.array([0.8, 0.0])
    positions = [captured, end]
    return covey.Game(
        team=covey.Team([[0.6, 0.0], [0.0, 1.0]], [0.0, 0.0]),
        disk=covey.PursuerDisk(),
        sensing="hidden",
        update_time=10.0,
        seed=0,
        objective={"name": "last-capture"},
        strategies={},
        status=covey.GameStatus.ALL_CAPTURED,
        guarantee=SECOND_CAPTURE,
        survival_time=SECOND_CAPTURE,
        planned_value=SECOND_CAPTURE,
        value=SECOND_CAPTURE,
        capture_sequence=np.array([0, 1]),
        capture_times=np.array([FIRST_CAPTURE, SECOND_CAPTURE]),
        times=np.array([0.0, FIRST_CAPTURE, SECOND_CAPTURE]),
        evader_positions=np.array(
            [[[0.6, 0.0], [0.0, 1.0]], [captured, turning_evader(FIRST_CAPTURE)], positions]
        ),
        evader_headings=np.array([[0.0, 0.0], [0.0, 0.8 * RATE], [0.0, RATE]]),
        evader_turns=np.array([[0.0, RATE], [0.0, 0.2 * RATE], [0.0, 0.0]]),
        guarantees=SECOND_CAPTURE - np.array([0.0, FIRST_CAPTURE, SECOND_CAPTURE]),
        assurances=np.full(3, np.inf),
        critical_sequences=np.array([[0, 1], [1, -1], [-1, -1]]),
        pursuer_sequences=np.array([[0, 1], [1, -1], [-1, -1]]),
        pursuer_positions=np.array([[0.0, 0.0], *positions]),
        disk_centers=np.array([[0.0, 0.0], *positions]),
        disk_radii=np.zeros(3),
    )


@cache
def simulated(sensing="hidden", seed=3, count=4, **options):
    """A game of section V of the paper, in few rows."""
    generator = np.random.default_rng(seed)
    positions = generator.uniform(-0.5, 0.5, (count, 2))
    team = covey.Team(PLACE + positions, np.arctan2(positions[:, 1], positions[:, 0]))
    disk = covey.PursuerDisk(PLACE, capture_radius=options.pop("capture_radius", 0.0))
    return covey.simulate(team, disk, sensing=sensing, update_time=0.25, **options)
