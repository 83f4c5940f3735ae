"""A team is what it was made of: broadcast, copied, read-only."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import covey


def test_defaults_are_those_of_the_paper():
    team = covey.Team([(0, 1), (2, 3)], [0, 1])
    assert team.speeds.tolist() == [0.25, 0.25]
    assert team.turn_rates.tolist() == [math.pi / 2, math.pi / 2]


def test_lists_and_integers_become_arrays_of_floats():
    team = covey.Team([(0, 1), (2, 3)], [0, 1], [1, 2], 3)
    for array in (team.positions, team.headings, team.speeds, team.turn_rates):
        assert array.dtype == np.float64
    assert team.positions.tolist() == [[0.0, 1.0], [2.0, 3.0]]
    assert team.headings.tolist() == [0.0, 1.0]
    assert team.speeds.tolist() == [1.0, 2.0]
    assert team.turn_rates.tolist() == [3.0, 3.0]


@pytest.mark.parametrize("rate", [0.5, [0.5], [0.5, 0.5, 0.5], np.float32(0.5)])
def test_one_number_stands_for_all(rate):
    team = covey.Team(np.zeros((3, 2)), np.zeros(3), rate, rate)
    assert team.speeds.tolist() == team.turn_rates.tolist() == [0.5] * 3


def test_length_is_the_number_of_evaders():
    assert len(covey.Team(np.zeros((5, 2)), np.zeros(5))) == 5


def test_later_changes_of_what_it_was_made_of_do_not_reach_it():
    positions, headings, speeds = np.zeros((2, 2)), np.zeros(2), np.full(2, 0.1)
    team = covey.Team(positions, headings, speeds)
    positions[:], headings[:], speeds[:] = 7.0, 7.0, 7.0
    assert not team.positions.any()
    assert not team.headings.any()
    assert team.speeds.tolist() == [0.1, 0.1]


@pytest.mark.parametrize("name", ["positions", "headings", "speeds", "turn_rates"])
def test_nothing_about_it_can_be_changed(name):
    team = covey.Team(np.zeros((2, 2)), np.zeros(2))
    with pytest.raises(ValueError, match="read-only"):
        getattr(team, name)[0] = 1.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        setattr(team, name, np.ones(2))


def test_some_of_a_team_in_a_given_order():
    team = covey.Team([(0, 1), (2, 3), (4, 5)], [6, 7, 8], [0.1, 0.2, 0.3], [1, 2, math.inf])
    taken = team.take(np.array([2, 0]))
    assert taken.as_rows().tolist() == [[4, 5, 8, 0.3, math.inf], [0, 1, 6, 0.1, 1]]


def test_rows_hold_place_heading_speed_and_turn_rate():
    team = covey.Team([(1, 2), (3, 4)], [5, 6], [0.7, 0.8], [9, math.inf])
    assert team.as_rows().tolist() == [[1, 2, 5, 0.7, 9], [3, 4, 6, 0.8, math.inf]]


def test_rows_are_a_copy():
    team = covey.Team([(1, 2)], [3])
    team.as_rows()[:] = 0.0
    assert team.positions.tolist() == [[1.0, 2.0]]


def test_one_heading_stands_for_all():
    assert covey.Team(np.zeros((3, 2)), 0.5).headings.tolist() == [0.5] * 3


def test_a_turning_radius_is_a_turn_rate_at_full_speed():
    team = covey.Team(np.zeros((2, 2)), 0.0, [20.0, 30.0], turn_radii=60.0)
    assert team.turn_rates.tolist() == [20 / 60, 30 / 60]


@pytest.mark.parametrize(
    ("speed", "radius", "rate"),
    [
        (20.0, 0.0, math.inf),
        (0.0, 0.0, math.inf),
        (0.0, 60.0, 0.0),
        (20.0, math.inf, 0.0),
        (0.0, math.inf, 0.0),
        (20.0, 5e-324, math.inf),
        (20.0, 1e-150, math.inf),
    ],
)
def test_turning_radii_at_their_limits(speed, radius, rate):
    """0 turns at once, also where nothing moves; inf can't turn; no rate exceeds the largest."""
    assert covey.Team([(0, 0)], 0.0, speed, turn_radii=radius).turn_rates.tolist() == [rate]


@pytest.mark.parametrize(
    ("rates", "told"),
    [
        (math.pi / 2, "pi/2"),
        (math.radians(90.0), "pi/2"),
        (2.0 * math.pi, "2 pi"),
        (0.75 * math.pi, "3 pi/4"),
        ([math.pi, 1.0], "1 to pi"),
        (1.5708, "1.5708"),
        (0.0, "0"),
        (math.inf, "inf"),
    ],
)
def test_turn_rates_are_told_as_they_are_typed(rates, told):
    team = covey.Team([(0.3, 0.1), (-0.2, 0.4)], 0.0, turn_rates=rates)
    assert repr(team).endswith(f"turn_rates={told})")
    assert f"<td>{told.split(' to ')[-1]}</td>" in team._repr_html_()
