"""Moving, turning or rescaling the whole game changes nothing but what it must."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import covey
from frames import Frame
from random_games import random_game, random_turns

ROUNDING = 1e-6
"""Of a survival time: what is left when rounding has passed through hundreds of new plans."""
CLEAR = 0.9
"""Share of the games that have one clear course. In the others, 1 in 100, several plans are
equally good at some moment, and rounding decides between them. (For the same reason the
pursuer keeps to a given order: several are the quickest.)"""
UPDATE_TIME = 0.06

BOTH = pytest.mark.parametrize("sensing", ["hidden", "visible"])
DISKS = pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.1, 0.0), (0.1, 0.03)])


def play(team, disk, sensing, **settings):
    order = covey.FixedSequence(range(len(team)))
    usual = {"pursuer": order, "update_time": UPDATE_TIME}
    return covey.simulate(team, disk, sensing=sensing, **(usual | settings))


def announcing(turns):
    """A team that announces these turns, once."""
    return lambda now: turns[list(now.evaders)] if now.time == 0.0 else now.turns


def random_games(radius, reach):
    for seed in range(20):
        generator = np.random.default_rng([seed, round(100 * radius), round(100 * reach)])
        yield random_game(generator, 1 + seed % 4, radius=radius, capture_radius=reach)


def assert_times_agree(pairs):
    """Survival times of games and of the same games seen otherwise."""
    one, other = np.array(list(pairs)).T
    agree = np.abs(one - other) <= ROUNDING
    assert agree.mean() >= CLEAR


@BOTH
@DISKS
@pytest.mark.parametrize(
    "frame", [Frame(offset=(3.0, -2.0)), Frame(1.0), Frame(time=60.0)], ids=str
)
def test_in_another_frame_the_team_survives_as_long(sensing, radius, reach, frame):
    def pair(team, disk):
        there = play(*frame.game(team, disk), sensing, update_time=frame.time * UPDATE_TIME)
        return play(team, disk, sensing).survival_time, there.survival_time / frame.time

    assert_times_agree(itertools.starmap(pair, random_games(radius, reach)))


@BOTH
@DISKS
def test_reflection(sensing, radius, reach):
    """Of given turns: a search that draws its starts at random has no mirror image."""
    for team, disk in random_games(radius, reach):
        turns = random_turns(np.random.default_rng(0), len(team))
        mirror = np.array([1.0, -1.0])
        there = (
            covey.Team(mirror * team.positions, -team.headings, team.speeds, team.turn_rates),
            covey.PursuerDisk(mirror * disk.center, disk.radius, disk.speed, disk.capture_radius),
        )
        survived = play(*there, sensing, evaders=announcing(-turns)).survival_time
        expected = play(team, disk, sensing, evaders=announcing(turns)).survival_time
        assert survived == pytest.approx(expected, abs=ROUNDING)


@BOTH
@DISKS
@pytest.mark.parametrize("length", [4.0, 0.125])
def test_a_power_of_two_of_the_unit_of_length_is_exact(sensing, radius, reach, length):
    """It shifts exponents, so that every number of the record comes out scaled, bit by bit."""
    for seed in range(12):
        generator = np.random.default_rng([seed, round(100 * radius), round(100 * reach)])
        team, disk = random_game(
            generator, 1 + seed % 6, radius=radius, capture_radius=reach, mixed=seed % 2 == 1
        )
        quickest = {"pursuer": covey.CommittedPursuer()}
        game = play(team, disk, sensing, **quickest)
        scaled = play(*Frame(length=length).game(team, disk), sensing, **quickest)
        assert np.array_equal(scaled.times, game.times)
        assert np.array_equal(scaled.guarantees, game.guarantees)
        assert np.array_equal(scaled.evader_positions, length * game.evader_positions)
        assert np.array_equal(scaled.evader_headings, game.evader_headings)
        assert np.array_equal(scaled.evader_turns, game.evader_turns)
        assert np.array_equal(scaled.pursuer_positions, length * game.pursuer_positions)
