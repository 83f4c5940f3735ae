"""A record that breaks a rule of the game is found."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import covey
from random_games import random_game
from soak import legal_game


@pytest.fixture(scope="module", params=["hidden", "visible"])
def game(request):
    team, disk = random_game(np.random.default_rng(1), 3, radius=0.1, capture_radius=0.05)
    return covey.simulate(team, disk, sensing=request.param, update_time=0.2)


def changed(game, name, index, by):
    values = getattr(game, name).copy()
    values[index] += by
    return dataclasses.replace(game, **{name: values})


@pytest.mark.parametrize(
    ("name", "index", "by", "check"),
    [
        ("guarantees", 2, math.nan, "numbers are finite"),
        ("times", 3, -0.5, "times are in order"),
        ("evader_positions", (2, 0, 1), 1e-9, "everyone flies what was announced"),
        ("evader_headings", (2, 1), 1e-9, "everyone flies what was announced"),
        ("evader_positions", (2, 0, 1), 1.0, "nobody is faster than it can be"),
        ("evader_headings", (2, 1), 1.0, "nobody is faster than it can be"),
        ("capture_times", 1, 1e-9, "each capture is a row of its own"),
        ("capture_sequence", 1, 1, "each capture is a row of its own"),
        ("evader_positions", (slice(None), slice(None), 0), 1.0, "who is captured is within reach"),
        ("guarantees", -1, 1e-9, "the last row is the end"),
    ],
)
def test_a_record_that_breaks_a_rule_is_found(game, name, index, by, check):
    assert max(legal_game.errors(game).values()) < 1e-13
    assert legal_game.errors(changed(game, name, index, by))[check] > 1e-10


def test_a_game_that_is_stopped_too_soon_is_found():
    team, disk = random_game(np.random.default_rng(1), 3)
    stopped = covey.simulate(team, disk, time_limit=0.1)
    assert legal_game.errors(stopped, 0.1)["the last row is the end"] < 1e-13
    assert legal_game.errors(stopped, 0.2)["the last row is the end"] > 0.1
    updates = dataclasses.replace(stopped, status=covey.GameStatus.UPDATE_LIMIT)
    assert legal_game.errors(updates, 0.1)["the last row is the end"] == math.inf


@pytest.mark.parametrize(
    ("name", "index", "by", "check", "sensing"),
    [
        ("pursuer_positions", (3, 0), 1.0, "the pursuer is no faster than it can be", "visible"),
        ("pursuer_positions", (3, 0), 1e-9, "a visible pursuer is where its disk is", "visible"),
        (
            "pursuer_positions",
            (slice(None), slice(None)),
            0.03,
            "a pursuer takes whomever it comes near",
            "visible",
        ),
        ("disk_radii", 3, 1e-9, "a hidden pursuer is a disk that grows and collapses", "hidden"),
        (
            "disk_centers",
            (3, 0),
            1e-9,
            "a hidden pursuer is a disk that grows and collapses",
            "hidden",
        ),
    ],
)
def test_a_pursuer_that_breaks_a_rule_is_found(game, name, index, by, check, sensing):
    if game.sensing == sensing:
        assert legal_game.errors(changed(game, name, index, by))[check] > 1e-10
