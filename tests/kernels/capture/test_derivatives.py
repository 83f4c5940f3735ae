"""Gradient and Hessian of a sequence's time against differences of Algorithm 1 itself."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from kernels import kernel_calls, reference_game
from random_games import random_game, random_turns

STEP = 1e-5
SLOPE_ERROR = 1e-8
"""Of a central difference over 2e-5 radians, in time units per radian."""
CURVATURE_ERROR = 1e-6
"""Of differences of the gradient, in time units per square radian, relative to the largest."""


def time_of(team, disk, sequence, total):
    def measured(turns):
        times = covey.capture_times(team, disk, turns, sequence)
        return times.sum() if total else times[-1]

    return measured


def gradient_of(team, disk, sequence, total):
    return lambda turns: kernel_calls.derivatives(team, disk, turns, sequence, total)[0]


def central(function, turns):
    """Differences of a function of the turns, one row an evader."""
    moves = STEP * np.eye(len(turns))
    return np.array([(function(turns + m) - function(turns - m)) / (2.0 * STEP) for m in moves])


def smooth_there(team, disk, turns, sequence):
    """Whether no capture is near the end of a turn or the edge of a disk, where slopes jump."""
    times = covey.capture_times(team, disk, turns, sequence)
    ends = [reference_game.turn_end(team, turns, i) for i in sequence]
    waits = np.diff(times, prepend=0.0)
    return (np.abs(times - ends) > 0.01).all() and ((waits == 0.0) | (waits > 0.01)).all()


def some_games(seed, wanted, **options):
    """Smooth games of one to five evaders."""
    generator = np.random.default_rng(seed)
    found = 0
    while found < wanted:
        count = int(generator.integers(1, 6))
        team, disk = random_game(generator, count, **options)
        turns, sequence = random_turns(generator, count), generator.permutation(count)
        if smooth_there(team, disk, turns, sequence):
            found += 1
            yield team, disk, turns, sequence


MEASURES = pytest.mark.parametrize("total", [False, True], ids=["last", "total"])
CASES = pytest.mark.parametrize(
    "options",
    [
        {},
        {"mixed": True},
        {"radius": 0.3},
        {"capture_radius": 0.03},
        {"radius": 0.2, "capture_radius": 0.1, "mixed": True},
    ],
    ids=str,
)


@CASES
@MEASURES
def test_gradient(options, total):
    for team, disk, turns, sequence in some_games(1, 30, **options):
        gradient, _ = kernel_calls.derivatives(team, disk, turns, sequence, total)
        wanted = central(time_of(team, disk, sequence, total), turns)
        assert gradient == pytest.approx(wanted, rel=SLOPE_ERROR, abs=SLOPE_ERROR)


@CASES
@MEASURES
def test_hessian(options, total):
    for team, disk, turns, sequence in some_games(2, 30, **options):
        _, hessian = kernel_calls.derivatives(team, disk, turns, sequence, total)
        wanted = central(gradient_of(team, disk, sequence, total), turns)
        largest = max(np.abs(wanted).max(), 1.0)
        assert hessian == pytest.approx(wanted, abs=CURVATURE_ERROR * largest)


def test_gradient_while_all_are_caught_turning_is_zero():
    generator = np.random.default_rng(3)
    team, disk = random_game(generator, 3)
    slow = covey.Team(team.positions, team.headings, team.speeds, 1e-3)
    gradient, hessian = kernel_calls.derivatives(slow, disk, np.array([1.0, -2.0, 3.0]), [2, 0, 1])
    assert not gradient.any()
    assert not hessian.any()


# One evader at a distance d that recedes at a speed b, itself v fast, is caught at T, where
# (v_p² - v²) T² - 2 b d T - d² = 0.  So dT/db = d T / ((v_p² - v²) T - b d).


def test_gradient_of_straight_flight_by_hand():
    """At right angles to the line of sight b = 0 and db/dδ = -v."""
    team = covey.Team([(3.0, 0.0)], [math.pi / 2], 0.6, math.inf)
    gradient, _ = kernel_calls.derivatives(team, covey.PursuerDisk(), np.array([0.0]), [0])
    assert gradient[0] == pytest.approx(-3.0 * 0.6 / 0.64, rel=1e-14, abs=0.0)


def test_curvature_of_straight_flight_by_hand():
    """Straight away b = v, db/dδ = 0 and d²b/dδ² = -v."""
    distance, speed = 2.0, 0.25
    time = distance / (1.0 - speed)
    team = covey.Team([(distance, 0.0)], [0.0], speed, math.inf)
    gradient, hessian = kernel_calls.derivatives(team, covey.PursuerDisk(), np.array([0.0]), [0])
    wanted = -speed * distance * time / ((1.0 - speed**2) * time - speed * distance)
    assert gradient[0] == pytest.approx(0.0, abs=1e-15)
    assert hessian[0, 0] == pytest.approx(wanted, rel=1e-14, abs=0.0)
