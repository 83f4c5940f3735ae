"""Angles: in [-π, π], the shorter way to a goal heading, unit vectors, headings away."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import covey
from covey.model.angles import away_from, unit_vectors, wrap_angle

ROUNDING = 1e-15
"""Of an angle, relative to the larger of it and a circle."""

_any_angle = st.floats(-1e6, 1e6)


@given(_any_angle)
def test_wrapped_is_the_same_direction_within_a_half_turn(angle):
    wrapped = float(wrap_angle(angle))
    assert -math.pi <= wrapped <= math.pi
    rounding = ROUNDING * (abs(angle) + 2.0 * math.pi)
    assert math.cos(wrapped) == pytest.approx(math.cos(angle), abs=rounding)
    assert math.sin(wrapped) == pytest.approx(math.sin(angle), abs=rounding)


@pytest.mark.parametrize(
    ("angle", "wrapped"),
    [(0.0, 0.0), (1.0, 1.0), (-3.0, -3.0), (4.0, 4.0 - 2 * math.pi), (-4.0, 2 * math.pi - 4.0),
     (2 * math.pi, 0.0), (100 * math.pi + 1.0, 1.0)],
)  # fmt: skip
def test_wrapped_by_hand(angle, wrapped):
    assert float(wrap_angle(angle)) == pytest.approx(wrapped, abs=1e-13)


@pytest.mark.parametrize("shape", [(), (3,), (2, 3)])
def test_wrapping_keeps_the_shape(shape):
    assert wrap_angle(np.full(shape, 7.0)).shape == shape


@given(st.lists(st.tuples(_any_angle, _any_angle), min_size=1, max_size=5))
def test_turns_lead_to_the_goal_the_shorter_way(pairs):
    headings, goals = np.array(pairs).T
    team = covey.Team(np.zeros((len(pairs), 2)), headings)
    turns = covey.turns_to(team, goals)
    assert (np.abs(turns) <= math.pi).all()
    miss = np.sin(0.5 * (headings + turns - goals))
    assert np.abs(miss).max() <= 1e-9


def test_turns_by_hand():
    team = covey.Team(np.zeros((4, 2)), [0.0, 3.0, -3.0, 1.0])
    turns = covey.turns_to(team, [1.0, -3.0, 3.0, 1.0])
    assert turns == pytest.approx([1.0, 2 * math.pi - 6.0, 6.0 - 2 * math.pi, 0.0], abs=1e-15)


def test_a_half_turn_is_made_to_the_right():
    turns = covey.turns_to(covey.Team(np.zeros((2, 2)), [0.0, 0.0]), [math.pi, -math.pi])
    assert turns.tolist() == [-math.pi, -math.pi]


def test_unit_vectors_by_hand():
    along = unit_vectors([0.0, math.pi / 2, -math.pi / 3])
    assert along == pytest.approx(np.array([[1, 0], [0, 1], [0.5, -math.sqrt(0.75)]]), abs=1e-15)


@pytest.mark.parametrize("shape", [(), (3,), (2, 3)])
def test_unit_vectors_have_one_more_axis(shape):
    assert unit_vectors(np.full(shape, 7.0)).shape == (*shape, 2)


@given(st.lists(_any_angle, min_size=1, max_size=5))
def test_unit_vectors_lead_away_at_their_angles(angles):
    headings = away_from([0.0, 0.0], unit_vectors(angles))
    assert np.abs(np.sin(0.5 * (headings - angles))).max() <= 1e-9


def test_away_from_a_centre_by_hand():
    headings = away_from([1.0, 2.0], [[2.0, 2.0], [1.0, 5.0], [0.0, 2.0], [0.0, 1.0], [1.0, 2.0]])
    expected = [0.0, math.pi / 2, math.pi, -0.75 * math.pi, 0.0]
    assert headings == pytest.approx(expected, rel=1e-15)


def test_away_from_a_centre_at_one_position():
    assert away_from([0.0, 0.0], [0.0, -3.0]) == -math.pi / 2
