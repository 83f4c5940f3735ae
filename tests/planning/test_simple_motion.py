"""Turning at once is the game of constant headings, and turning fast comes as close as it must."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given

import covey
from random_games import games, random_game, random_turns, time_rounding


def constant_heading_times(team, disk, headings):
    """Capture in the order 0..N-1 of evaders with constant velocity: a quadratic equation each."""
    times, time = [], 0.0
    place, radius = disk.center, disk.radius + disk.capture_radius
    for i, heading in enumerate(headings):
        velocity = team.speeds[i] * np.array([math.cos(heading), math.sin(heading)])
        off = team.positions[i] + velocity * time - place
        closing = disk.speed**2 - team.speeds[i] ** 2
        half = off @ velocity - disk.speed * radius
        outside = off @ off - radius**2
        if outside > 0.0:
            roots = np.roots([closing, -2.0 * half, -outside])
            time += roots.max()
        times.append(time)
        place, radius = team.positions[i] + velocity * time, 2.0 * disk.capture_radius
    return np.array(times)


def with_turn_rate(team, turn_rate):
    return covey.Team(team.positions, team.headings, team.speeds, turn_rate)


@given(games(most=4, fastest=0.7))
def test_an_infinite_turn_rate_is_simple_motion(game):
    team, disk, turns = game
    agile = with_turn_rate(team, math.inf)
    wanted = constant_heading_times(team, disk, team.headings + turns)
    found = covey.capture_times(agile, disk, turns, range(len(team)))
    assert found == pytest.approx(wanted, rel=0.0, abs=time_rounding(team, disk, wanted[-1]))


@pytest.mark.parametrize("turn_rate", [1e2, 1e4, 1e6, 1e9])
def test_the_difference_is_at_most_what_the_turns_take(turn_rate):
    """A turn that takes t_c displaces the evader by 2 v t_c at most, and a capture by as much."""
    generator = np.random.default_rng(5)
    gain = (1.0 + 0.25) / (1.0 - 0.25)
    for count in (1, 2, 3, 4):
        team, disk = random_game(generator, count)
        turns = random_turns(generator, count)
        at_once = covey.guaranteed_survival(with_turn_rate(team, math.inf), disk, turns).time
        fast = covey.guaranteed_survival(with_turn_rate(team, turn_rate), disk, turns).time
        displaced = 2.0 * 0.25 * math.pi / turn_rate
        allowed = displaced / (1.0 - 0.25) * sum(gain**k for k in range(count))
        assert abs(fast - at_once) <= allowed + time_rounding(team, disk, at_once)
        assert fast != at_once


def test_plans_come_together_too():
    generator = np.random.default_rng(6)
    for count in (1, 2, 3):
        team, disk = random_game(generator, count)
        at_once = covey.plan(with_turn_rate(team, math.inf), disk).survival_time
        fast = covey.plan(with_turn_rate(team, 1e7), disk).survival_time
        assert fast == pytest.approx(at_once, rel=1e-6, abs=0.0)
