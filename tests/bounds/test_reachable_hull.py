"""What a turn-limited evader can reach: hand cases, random flights, and the polygons' corners."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.bounds.reachable_hull import corners_of, largest_displacements
from flights import random_flight


def unit(angles):
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def test_straight_ahead_all_the_way_counts():
    assert largest_displacements(np.zeros(1), 3.0, 0.5, 2.0) == pytest.approx(1.5)


def test_behind_the_evader_by_hand():
    """Half a circle of radius 1 takes π; from then on it flies straight back."""
    assert largest_displacements(np.array([math.pi]), math.pi + 2.0, 1.0, 1.0) == pytest.approx(2.0)


def test_to_the_side_while_still_turning_by_hand():
    """An eighth of a circle of radius 1: 1 - cos(45°) to the side."""
    side = largest_displacements(np.array([math.pi / 2]), math.pi / 4, 1.0, 1.0)
    assert side == pytest.approx(1.0 - math.sqrt(0.5))


@pytest.mark.parametrize("turn_rate", [1e-9, 1e-3, 1.0, 1e3, 1e9])
def test_limits_of_the_turn_rate_are_those_of_straight_flight_and_of_simple_motion(turn_rate):
    off = np.linspace(-math.pi, math.pi, 41)
    straight = largest_displacements(off, 1.0, 0.25, 0.0)
    free = largest_displacements(off, 1.0, 0.25, math.inf)
    found = largest_displacements(off, 1.0, 0.25, turn_rate)
    assert (straight - 1e-12 <= found).all()
    assert (found <= free + 1e-12).all()
    if turn_rate == 1e-9:
        assert found == pytest.approx(straight, abs=1e-9)
    if turn_rate == 1e9:
        assert found == pytest.approx(free, abs=1e-8)


@pytest.mark.parametrize("seed", range(8))
def test_no_flight_gets_farther_and_one_gets_as_far(seed):
    generator = np.random.default_rng(seed)
    turn_rate, time = generator.uniform(0.5, 3.0), generator.uniform(0.2, 4.0)
    team = covey.Team([[0.4, -0.2]], [generator.uniform(-3, 3)], 0.25, turn_rate)
    directions = np.linspace(-math.pi, math.pi, 73)
    most = largest_displacements(directions - team.headings[0], time, 0.25, turn_rate)
    for _ in range(20):
        moved = random_flight(team, time, generator)[-1, 0] - team.positions[0]
        assert (unit(directions) @ moved <= most + 1e-12).all()


@pytest.mark.parametrize("turn_rate", [0.0, 0.7, math.pi, math.inf])
@pytest.mark.parametrize("seed", range(3))
def test_corners_surround_all_flights_at_all_later_times(seed, turn_rate):
    generator = np.random.default_rng(seed)
    team = covey.Team([[0.4, -0.2]], [generator.uniform(-3, 3)], 0.25, turn_rate)
    touching = [np.sort(generator.uniform(0.0, 2.0 * math.pi, 40))]
    opening, known = 0.3, 0.9
    corners = corners_of(team, touching, np.array([known]), opening)
    directions = unit(touching[0])
    for time in (known, 1.7, 4.0):
        flown = corners.speeds[0] * (time - opening)
        polygon = corners.positions[0] + flown[:, np.newaxis] * unit(corners.headings[0])
        reach = (polygon @ directions.T).max(axis=0)
        for _ in range(20):
            place = random_flight(team, time, generator)[-1, 0]
            assert (directions @ place <= reach + 1e-12).all()


def test_corners_touch_what_can_be_reached():
    """With dense tangents the polygon is hardly larger than the hull."""
    team = covey.Team([[0.0, 0.0]], [0.0], 0.25, 1.0)
    touching = np.linspace(0.0, 2.0 * math.pi, 2000, endpoint=False)
    corners = corners_of(team, [touching], np.array([2.0]), 2.0)
    reach = (corners.positions[0] @ unit(touching).T).max(axis=0)
    assert reach == pytest.approx(largest_displacements(touching, 2.0, 0.25, 1.0), abs=1e-12)


def test_tangents_that_coincide_count_once():
    team = covey.Team([[0.0, 0.0]], [0.3], 0.25, 1.0)
    touching = np.linspace(0.1, 2.0 * math.pi, 50, endpoint=False)
    twice = np.sort(np.concatenate([touching, touching + 1e-9]))
    once = corners_of(team, [touching], np.ones(1), 0.0)
    found = corners_of(team, [twice], np.ones(1), 0.0)
    assert found.positions == pytest.approx(once.positions, abs=1e-8)
    assert np.isfinite(found.positions).all()
