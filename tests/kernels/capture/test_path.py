"""The Dubins path (eq. 5) is the one that the equations of motion give, and it has no seams."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from kernels import kernel_calls, reference_game
from random_games import EPSILON, random_game, random_turns

INTEGRATED = 1e-10
"""How far the numerical integration may end from the path, in squares of side 1."""
ROUNDING = 16.0 * EPSILON
DIFFERENCED = 1e-8
"""Error of a central difference over 1e-5 time units, in lengths per time."""


def one(heading=0.0, speed=0.25, turn_rate=math.pi / 2):
    return covey.Team([(0.3, -0.2)], [heading], speed, turn_rate)


@pytest.mark.parametrize("seed", range(8))
def test_path_solves_the_equations_of_motion(seed):
    generator = np.random.default_rng(seed)
    team, _ = random_game(generator, 3)
    turns = random_turns(generator, 3)
    for i in range(3):
        for time in generator.uniform(0.0, 4.0, 4):
            flown = reference_game.flown_place(team, turns, i, time)
            assert kernel_calls.place(team, turns, i, time) == pytest.approx(flown, abs=INTEGRATED)


@pytest.mark.parametrize("seed", range(4))
def test_velocity_is_the_derivative_of_the_position(seed):
    generator = np.random.default_rng(seed)
    team, _ = random_game(generator, 3)
    turns = random_turns(generator, 3)
    half = 0.5e-5
    for i in range(3):
        end = reference_game.turn_end(team, turns, i)
        for time in (0.1 * end, 0.9 * end, 1.5 * end, end + 3.0):
            ahead = kernel_calls.place(team, turns, i, time + half)
            behind = kernel_calls.place(team, turns, i, time - half)
            difference = (ahead - behind) / (2.0 * half)
            assert kernel_calls.motion(team, turns, i, time) == pytest.approx(
                difference, abs=DIFFERENCED
            )


def test_quarter_turn_ends_a_radius_ahead_and_a_radius_to_the_side():
    radius = 0.25 / (math.pi / 2)
    for side in (1.0, -1.0):
        end = kernel_calls.place(one(), [side * math.pi / 2], 0, 1.0)
        assert end == pytest.approx([0.3 + radius, -0.2 + side * radius], abs=ROUNDING)
        later = kernel_calls.place(one(), [side * math.pi / 2], 0, 3.0)
        assert later == pytest.approx([0.3 + radius, -0.2 + side * (radius + 0.5)], abs=ROUNDING)


@pytest.mark.parametrize("turn", [-math.pi, -1.0, -1e-9, 1e-9, 0.3, math.pi])
@pytest.mark.parametrize("turn_rate", [1e-3, math.pi / 2, 1e6])
def test_no_seam_where_the_turn_ends(turn, turn_rate):
    team = one(heading=2.0, turn_rate=turn_rate)
    end = abs(turn) / turn_rate
    before, after = np.nextafter(end, 0.0), np.nextafter(end, math.inf)
    size = 1.0 + 0.25 * end
    for read in (kernel_calls.place, kernel_calls.motion):
        seam = np.abs(read(team, [turn], 0, before) - read(team, [turn], 0, after)).max()
        assert seam <= ROUNDING * size


def test_speed_never_changes():
    for time in (0.0, 0.5, 0.999, 1.0, 2.0):
        assert math.hypot(*kernel_calls.motion(one(), [1.5], 0, time)) == pytest.approx(
            0.25, rel=ROUNDING, abs=0.0
        )


@pytest.mark.parametrize("turn", [-2.0, 0.0, 2.0])
def test_without_a_turn_rate_the_turn_is_ignored(turn):
    straight = [0.3 + 0.25 * 4.0, -0.2]
    assert kernel_calls.place(one(turn_rate=0.0), [turn], 0, 4.0) == pytest.approx(
        straight, abs=ROUNDING
    )


def test_a_circle_of_any_size_is_flown_to_full_precision():
    """At 1e-12 radians a time unit the circle is 5e11 lengths wide, the arc all but straight."""
    straight = [0.3 + 0.25 * 4.0, -0.2]
    place = kernel_calls.place(one(turn_rate=1e-12), [1.0], 0, 4.0)
    assert place == pytest.approx(straight, abs=1e-11)
    bent_by = 0.5 * 0.25 * 1e-12 * 4.0**2
    assert place[1] - straight[1] == pytest.approx(bent_by, abs=ROUNDING)


@pytest.mark.parametrize("turn", [-math.pi, -1.0, 0.0, 0.5, math.pi])
def test_an_infinite_turn_rate_turns_at_once(turn):
    time = 4.0
    goal = 2.0 + turn
    there = [0.3 + 0.25 * time * math.cos(goal), -0.2 + 0.25 * time * math.sin(goal)]
    team = one(heading=2.0, turn_rate=math.inf)
    assert kernel_calls.place(team, [turn], 0, time) == pytest.approx(there, abs=ROUNDING)
    assert kernel_calls.place(team, [turn], 0, 0.0) == pytest.approx([0.3, -0.2], abs=0.0)


def test_a_half_turn_ends_a_diameter_to_the_side_that_was_turned_to():
    diameter = 2.0 * 0.25 / (math.pi / 2)
    for side in (1.0, -1.0):
        end = kernel_calls.place(one(), [side * math.pi], 0, 2.0)
        assert end == pytest.approx([0.3, -0.2 + side * diameter], abs=ROUNDING)
