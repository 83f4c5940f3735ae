"""What must not matter doesn't: where the game is, how it is turned, its units, its numbering."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import covey
from frames import Frame
from random_games import extent, games, random_game, random_turns, time_rounding

SOLVED = 1e-8
"""Of the survival time, relative: a plan ends where a step promises less than 1e-9."""

_angles = st.floats(-math.pi, math.pi)
_offsets = st.floats(-10.0, 10.0)


def times_of(team, disk, turns):
    """The times of one capture sequence, and the least of all."""
    in_order = covey.capture_times(team, disk, turns, range(len(team)))
    return np.append(in_order, covey.guaranteed_survival(team, disk, turns).time)


def assert_same(game, other):
    """Up to what rounding may do in either of two games."""
    found, wanted = times_of(*other), times_of(*game)
    rounding = sum(time_rounding(team, disk, wanted.max()) for team, disk, _ in (game, other))
    assert found == pytest.approx(wanted, rel=0.0, abs=rounding)


@given(games(most=3, fastest=0.7), _offsets, _offsets)
def test_translation(game, x, y):
    team, disk, turns = game
    frame = Frame(offset=extent(team, disk) * np.array([x, y]))
    assert_same(game, (*frame.game(team, disk), turns))


@given(games(most=3, fastest=0.7), _angles)
def test_rotation(game, angle):
    team, disk, turns = game
    assert_same(game, (*Frame(angle).game(team, disk), turns))


@given(games(most=4))
def test_reflection_turns_the_other_way(game):
    team, disk, turns = game
    mirror = np.array([1.0, -1.0])
    reflected = covey.Team(team.positions * mirror, -team.headings, team.speeds, team.turn_rates)
    center = disk.center * mirror
    there = covey.PursuerDisk(center, disk.radius, disk.speed, disk.capture_radius)
    assert times_of(reflected, there, -turns).tolist() == times_of(team, disk, turns).tolist()


@given(games(most=4), st.randoms(use_true_random=False))
def test_numbering(game, random):
    team, disk, turns = game
    order = list(range(len(team)))
    random.shuffle(order)
    renamed = covey.Team(
        team.positions[order], team.headings[order], team.speeds[order], team.turn_rates[order]
    )
    place = np.argsort(order)
    found = covey.capture_times(renamed, disk, turns[order], place)
    assert found.tolist() == covey.capture_times(team, disk, turns, range(len(team))).tolist()
    least = covey.guaranteed_survival(team, disk, turns).time
    assert covey.guaranteed_survival(renamed, disk, turns[order]).time == least


@given(games(most=3, fastest=0.7), st.floats(0.1, 10.0), st.floats(0.1, 10.0))
def test_units(game, length, time):
    team, disk, turns = game
    other_team, other_disk = Frame(length=length, time=time).game(team, disk)
    wanted = time * times_of(team, disk, turns)
    rounding = 2.0 * time_rounding(other_team, other_disk, wanted.max())
    assert times_of(other_team, other_disk, turns) == pytest.approx(wanted, rel=0.0, abs=rounding)


@given(games(most=4), st.integers(-20, 20), st.integers(-20, 20))
def test_units_that_are_powers_of_two_change_no_bit(game, length, time):
    """So no constant in the code has a unit."""
    team, disk, turns = game
    other = Frame(length=2.0**length, time=2.0**time).game(team, disk)
    wanted = 2.0**time * times_of(team, disk, turns)
    assert times_of(*other, turns).tolist() == wanted.tolist()


@given(games(most=4), st.integers(-3, 3))
def test_full_circles_in_a_heading_say_nothing(game, circles):
    team, disk, turns = game
    headings = team.headings + circles * 2.0 * math.pi
    assert_same(
        game, (covey.Team(team.positions, headings, team.speeds, team.turn_rates), disk, turns)
    )


@pytest.mark.parametrize("seed", range(5))
def test_an_ascent_in_a_mirror_is_the_ascent_mirrored(seed):
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3)
    turns = random_turns(generator, 3)
    plan = covey.plan(team, disk, starts=1, warm_start=turns)
    mirrored = covey.Team(team.positions * [1.0, -1.0], -team.headings)
    there = covey.PursuerDisk(disk.center * [1.0, -1.0])
    other = covey.plan(mirrored, there, starts=1, warm_start=-turns)
    assert other.survival_time == pytest.approx(plan.survival_time, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("time", [-30, -10, 10, 30])
@pytest.mark.parametrize("length", [-20, 20])
def test_a_plan_is_worth_the_same_in_any_unit(time, length):
    generator = np.random.default_rng(11)
    for count in (1, 2, 3, 4) * 4:
        team, disk = random_game(generator, count)
        plan = covey.plan(team, disk, starts=4)
        frame = Frame(length=2.0**length, time=2.0**time)
        other = covey.plan(*frame.game(team, disk), starts=4)
        assert other.survival_time == pytest.approx(
            2.0**time * plan.survival_time, rel=SOLVED, abs=0.0
        )
