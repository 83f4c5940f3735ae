"""`mincap` (eq. 7) solves its equation, at every scale, and agrees with plain time stepping."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given

import covey
from kernels import reference_game
from random_games import EPSILON, extent, games, random_game, random_turns

RESIDUAL = 16.0 * EPSILON
"""Of the equation, relative to the lengths that are subtracted in it."""
STEPPED = 1e-13
"""Of the time found by stepping, relative."""


def assert_root(team, disk, turns):
    """g vanishes at the time returned; before, it falls to it with a slope within its bounds."""
    time = covey.capture_times(team, disk, turns, [0])[0]
    reach = disk.radius + disk.capture_radius

    def gap(moment):
        return reference_game.gap(team, turns, 0, disk.center, reach, 0.0, disk.speed, moment)

    rounding = RESIDUAL * (extent(team, disk) + 2.0 * disk.speed * time)
    if time == 0.0:
        assert gap(0.0) <= rounding
        return
    assert abs(gap(time)) <= rounding
    speed = team.speeds[0]
    for share in (0.0, 0.1, 0.5, 0.9, 0.999, 1.0 - 1e-9):
        left = time * (1.0 - share)
        before = gap(share * time)
        assert (disk.speed - speed) * left - rounding <= before
        assert before <= (disk.speed + speed) * left + rounding


@given(games(most=1, fastest=0.999999))
def test_root_at_every_scale(game):
    assert_root(*game)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("turn_rate", [0.0, 1e-12, 1e-6, 1.0, 50.0, 1e6, 1e12, math.inf])
@pytest.mark.parametrize("speed", [0.0, 0.25, 0.999, 0.999999])
def test_root_at_the_extremes(scale, turn_rate, speed):
    generator = np.random.default_rng(round(100 * speed))
    for _ in range(20):
        team = covey.Team(
            [scale * generator.uniform(-1.0, 1.0, 2)],
            [generator.uniform(-math.pi, math.pi)],
            speed,
            turn_rate / scale,
        )
        disk = covey.PursuerDisk((0.0, 0.0), generator.choice([0.0, 0.3 * scale]))
        assert_root(team, disk, random_turns(generator, 1))


@pytest.mark.parametrize("laps", [0.5, 3.0, 40.0])
def test_root_while_the_evader_circles(laps):
    """Turns beyond a half are legal for a value: one that circles is caught within the turn."""
    generator = np.random.default_rng(3)
    for _ in range(50):
        team, disk = random_game(generator, 1)
        team = covey.Team(team.positions, team.headings, 0.95, generator.uniform(0.5, 30.0))
        assert_root(team, disk, [laps * 2.0 * math.pi])


def test_root_where_pursuer_and_evader_all_but_meet():
    """The evader comes back to the disk's centre, or grazes it, while it turns."""
    for radius in (0.0, 1e-9, 1e-3):
        for off in (0.0, 1e-12, 1e-7, 1e-3):
            team = covey.Team([(off, radius * (1.0 + 1e-9) + off)], [0.0], 0.999, 3.0)
            assert_root(team, covey.PursuerDisk(radius=radius), [math.pi])
            assert_root(team, covey.PursuerDisk(radius=radius), [-math.pi])


@pytest.mark.parametrize("seed", range(40))
def test_agrees_with_time_stepping(seed):
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 1, radius=0.1 * (seed % 3), mixed=seed % 2 == 0)
    turns = random_turns(generator, 1)
    stepped = reference_game.stepped_capture(team, disk, turns)
    found = covey.capture_times(team, disk, turns, [0])[0]
    assert found == pytest.approx(stepped, rel=STEPPED, abs=STEPPED)


@given(games(most=1))
@example((covey.Team([(1.0, 0.0)], [0.0]), covey.PursuerDisk(), np.array([math.pi])))
def test_a_larger_disk_never_captures_later(game):
    team, disk, turns = game
    wider = covey.PursuerDisk(disk.center, 1.5 * disk.radius, disk.speed, disk.capture_radius)
    rounding = RESIDUAL * (extent(team, disk) / disk.speed)
    sooner = covey.capture_times(team, wider, turns, [0])[0]
    later = covey.capture_times(team, disk, turns, [0])[0]
    assert sooner <= later * (1.0 + RESIDUAL) + rounding / (1.0 - team.speeds[0] / disk.speed)
