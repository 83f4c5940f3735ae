"""`mincap` (eq. 7) where the answer can be found on paper."""

from __future__ import annotations

import math

import pytest

import covey
from kernels import reference_game
from random_games import EPSILON, fleeing

ROUNDING = 8.0 * EPSILON
CENTER = (0.2, -0.3)


def capture_time(team, disk, turn=0.0):
    return covey.capture_times(team, disk, [turn], [0])[0]


@pytest.mark.parametrize("speed", [0.0, 0.25, 0.9, 0.999999])
@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.5, 0.0), (0.0, 0.1), (0.5, 0.1)])
def test_straight_flight(speed, radius, reach):
    disk = covey.PursuerDisk((0.0, 0.0), radius, 1.0, reach)
    team = fleeing(2.0, speed=speed, bearing=0.0)
    wanted = (2.0 - radius - reach) / (1.0 - speed)
    assert capture_time(team, disk) == pytest.approx(wanted, rel=ROUNDING / (1.0 - speed), abs=0.0)


@pytest.mark.parametrize("speed", [0.0, 0.25, 0.9, 0.999999])
def test_head_on(speed):
    disk = covey.PursuerDisk(CENTER, 0.5, 1.0, 0.1)
    team = fleeing(-2.0, speed=speed, center=CENTER)
    assert capture_time(team, disk) == pytest.approx(1.4 / (1.0 + speed), rel=ROUNDING, abs=0.0)


def test_passing_at_a_right_angle():
    team = covey.Team([(3.0, 0.0)], [math.pi / 2], 0.6, 0.0)
    assert capture_time(team, covey.PursuerDisk()) == pytest.approx(
        3.0 / 0.8, rel=ROUNDING, abs=0.0
    )


def test_time_is_length_over_speed_for_one_that_stands():
    team = covey.Team([(3.0, 4.0)], [1.0], 0.0)
    assert capture_time(team, covey.PursuerDisk(speed=2.0), 1.0) == 2.5


@pytest.mark.parametrize("turn_rate", [0.0, math.inf, math.pi / 2, 1e-12, 1e12])
def test_the_turn_rate_says_nothing_about_one_that_does_not_turn(turn_rate):
    team = covey.Team([(2.0, 0.0)], [0.0], 0.25, turn_rate)
    assert capture_time(team, covey.PursuerDisk(radius=0.5)) == 2.0


def test_turning_at_once_is_flying_away_at_once():
    team = covey.Team([(2.0, 0.0)], [0.5], 0.25, math.inf)
    assert capture_time(team, covey.PursuerDisk(radius=0.5), -0.5) == pytest.approx(
        2.0, rel=1e-15, abs=0.0
    )


@pytest.mark.parametrize("share", [0.25, 0.5, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 2.0])
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("radius", [0.0, 0.05])
def test_capture_at_a_chosen_moment_before_at_and_after_the_end_of_the_turn(share, side, radius):
    """The disk's centre is laid so that the disk reaches the evader then; the turn ends at 1."""
    turns = [side * math.pi / 2]
    team = covey.Team([(0.3, -0.2)], [2.0], 0.25)
    there = reference_game.place(team, turns, 0, share)
    for direction in (0.0, 1.0, 3.0, 5.0):
        off = (share + radius) * math.cos(direction), (share + radius) * math.sin(direction)
        disk = covey.PursuerDisk(there - off, radius)
        assert capture_time(team, disk, turns[0]) == pytest.approx(share, rel=ROUNDING, abs=0.0)


@pytest.mark.parametrize("offset", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("turn", [0.0, 3.0])
def test_in_the_disk_or_on_its_edge_capture_is_immediate(offset, turn):
    disk = covey.PursuerDisk((1.0, 0.0), 0.5)
    assert capture_time(covey.Team([(1.0 - offset, 0.0)], [2.0]), disk, turn) == 0.0


def test_just_outside_the_disk_capture_is_not_immediate():
    team = covey.Team([(0.5 + 2.0**-40, 0.0)], [0.0])
    disk = covey.PursuerDisk(radius=0.5)
    assert capture_time(team, disk) == pytest.approx(2.0**-40 / 0.75, rel=1e-3, abs=0.0)
    assert capture_time(team, disk, 1.0) > 0.0


def test_on_top_of_another_both_are_captured_at_once():
    team = covey.Team([(2.0, 0.0), (2.0, 0.0)], [0.0, 0.0], 0.25)
    assert covey.capture_times(team, covey.PursuerDisk(), [0.0, 0.0], [1, 0]) == pytest.approx(
        [2.0 / 0.75] * 2, rel=ROUNDING, abs=0.0
    )


def test_second_capture_starts_where_the_first_one_was():
    team = covey.Team([(1.0, 0.0), (-2.0, 0.0)], [0.0, 0.0], 0.0)
    times = covey.capture_times(team, covey.PursuerDisk(radius=0.25), [0.0, 0.0], [0, 1])
    assert times.tolist() == [0.75, 3.75]


def test_after_a_capture_the_pursuer_is_within_its_reach_of_the_place():
    team = covey.Team([(1.0, 0.0), (-2.0, 0.0)], [0.0, 0.0], 0.0)
    disk = covey.PursuerDisk(radius=0.25, capture_radius=0.125)
    times = covey.capture_times(team, disk, [0.0, 0.0], [0, 1])
    assert times.tolist() == [0.625, 0.625 + 3.0 - 2.0 * 0.125]


def test_one_passed_over_is_captured_when_its_turn_comes():
    """Evader 1 is within 2ρ of the place of the first capture: no time goes by."""
    team = covey.Team([(1.0, 0.0), (1.125, 0.0)], [0.0, 0.0], 0.0)
    disk = covey.PursuerDisk(capture_radius=0.125)
    times = covey.capture_times(team, disk, [0.0, 0.0], [0, 1])
    assert times.tolist() == [0.875, 0.875]
