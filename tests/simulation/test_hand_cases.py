"""Whole games that can be worked out on the back of an envelope."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from random_games import fleeing

ROUNDING = 1e-12
"""Relative, of a number of about one that is added up from a hundred intervals."""

BOTH = pytest.mark.parametrize("sensing", ["hidden", "visible"])


def simulated(frame, team, disk, **settings):
    """The game in a frame; its updates are a hundredth of a unit of time apart."""
    team, disk = frame.game(team, disk)
    return covey.simulate(team, disk, update_time=0.01 * frame.time, **settings)


@BOTH
@pytest.mark.parametrize("radius", [0.0, 0.3])
@pytest.mark.parametrize("reach", [0.0, 0.1])
@pytest.mark.parametrize("evaders", [covey.OpenLoop(), covey.IterativeOpenLoop()])
def test_one_that_flees_straight_away(frame, sensing, radius, reach, evaders):
    """The gap closes at the difference of the speeds."""
    team = fleeing(1.0, speed=0.25)
    disk = covey.PursuerDisk((0.0, 0.0), radius, 1.0, reach)
    game = simulated(frame, team, disk, evaders=evaders, sensing=sensing)
    expected = frame.time * (1.0 - radius - reach) / 0.75
    assert game.survival_time == pytest.approx(expected, rel=ROUNDING)
    assert game.guarantee == pytest.approx(expected, rel=ROUNDING)


@BOTH
@pytest.mark.parametrize("reach", [0.0, 0.5])
def test_one_that_is_in_the_disk_is_captured_at_once(frame, sensing, reach):
    disk = covey.PursuerDisk((0.0, 0.0), 0.6 * (1.0 + ROUNDING), 1.0, reach)
    game = simulated(frame, fleeing(0.6), disk, sensing=sensing)
    assert game.survival_time == game.guarantee == 0.0
    assert game.times.tolist() == [0.0, 0.0]


@BOTH
@pytest.mark.parametrize("reach", [0.0, 0.125])
def test_a_row_of_targets_that_stand(frame, sensing, reach):
    """Fly to the near end, then along the row, to its other end.

    Each capture leaves a hidden pursuer anywhere within its reach, so it gains twice the reach on
    every leg but the first. A visible one stays on its line, and gains it once.
    """
    team = covey.Team([(1.0, 0.0), (2.0, 0.0), (3.0, 0.0)], np.zeros(3), speeds=0.0)
    disk = covey.PursuerDisk((0.0, 0.0), 0.0, 1.0, reach)
    game = simulated(frame, team, disk, sensing=sensing)
    gain = reach * np.array([1, 3, 5] if sensing == "hidden" else [1, 1, 1])
    assert game.capture_times == pytest.approx(frame.time * ([1, 2, 3] - gain), rel=ROUNDING)
    assert game.capture_sequence.tolist() == [0, 1, 2]


@BOTH
def test_one_that_flies_the_half_circle_back(frame, sensing):
    """It turns about a point that is half a unit away, and meets the pursuer where it comes out."""
    turning = 1.0
    radius = 0.25 * turning / math.pi
    team = covey.Team([(1.0, 0.0)], [math.pi / 2], speeds=0.25, turn_rates=math.pi / turning)
    disk = covey.PursuerDisk((1.0 - 2.0 * radius - turning, 0.0))
    game = simulated(
        frame,
        team,
        disk,
        evaders=lambda situation: [math.pi] if situation.time == 0.0 else situation.turns,
        sensing=sensing,
    )
    assert game.survival_time == pytest.approx(frame.time * turning, rel=ROUNDING)
    there = frame.points([1.0 - 2.0 * radius, 0.0])
    assert game.evader_positions[-1, 0] == pytest.approx(there, abs=ROUNDING * frame.length)
    expected = 1.5 * math.pi + frame.angle
    assert game.evader_headings[-1, 0] == pytest.approx(expected, abs=ROUNDING)
