"""Moving, turning or rescaling the whole game changes nothing but what it must."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
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


def moved(team, disk, matrix, offset, headings):
    return (
        covey.Team(team.positions @ matrix.T + offset, headings, team.speeds, team.turn_rates),
        covey.PursuerDisk(
            matrix @ disk.center + offset, disk.radius, disk.speed, disk.capture_radius
        ),
    )


def rescaled(team, disk, length, time):
    speed = length / time
    return (
        covey.Team(
            length * team.positions, team.headings, speed * team.speeds, team.turn_rates / time
        ),
        covey.PursuerDisk(
            length * disk.center,
            length * disk.radius,
            speed * disk.speed,
            length * disk.capture_radius,
        ),
    )


def assert_times_agree(pairs):
    """Survival times of games and of the same games seen otherwise."""
    one, other = np.array(list(pairs)).T
    agree = np.abs(one - other) <= ROUNDING
    assert agree.mean() >= CLEAR


@BOTH
@DISKS
def test_translation(sensing, radius, reach):
    def pair(team, disk):
        there = moved(team, disk, np.eye(2), np.array([3.0, -2.0]), team.headings)
        return play(team, disk, sensing).survival_time, play(*there, sensing).survival_time

    assert_times_agree(itertools.starmap(pair, random_games(radius, reach)))


@BOTH
@DISKS
def test_rotation(sensing, radius, reach):
    angle = 1.0
    cosine, sine = math.cos(angle), math.sin(angle)
    matrix = np.array([[cosine, -sine], [sine, cosine]])

    def pair(team, disk):
        there = moved(team, disk, matrix, np.zeros(2), team.headings + angle)
        return play(team, disk, sensing).survival_time, play(*there, sensing).survival_time

    assert_times_agree(itertools.starmap(pair, random_games(radius, reach)))


@BOTH
@DISKS
def test_unit_of_time(sensing, radius, reach):
    def pair(team, disk):
        slow = play(
            *rescaled(team, disk, length=1.0, time=60.0), sensing, update_time=60.0 * UPDATE_TIME
        )
        return play(team, disk, sensing).survival_time, slow.survival_time / 60.0

    assert_times_agree(itertools.starmap(pair, random_games(radius, reach)))


@BOTH
@DISKS
def test_reflection(sensing, radius, reach):
    """Of given turns: a search that draws its starts at random has no mirror image."""
    for team, disk in random_games(radius, reach):
        turns = random_turns(np.random.default_rng(0), len(team))
        there = moved(team, disk, np.diag([1.0, -1.0]), np.zeros(2), -team.headings)
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
        scaled = play(*rescaled(team, disk, length, time=1.0), sensing, **quickest)
        assert np.array_equal(scaled.times, game.times)
        assert np.array_equal(scaled.guarantees, game.guarantees)
        assert np.array_equal(scaled.evader_positions, length * game.evader_positions)
        assert np.array_equal(scaled.evader_headings, game.evader_headings)
        assert np.array_equal(scaled.evader_turns, game.evader_turns)
        assert np.array_equal(scaled.pursuer_positions, length * game.pursuer_positions)
