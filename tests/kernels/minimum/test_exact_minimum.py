"""The exact minimum on two cores: the same programme, shared out."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from covey.planning import exact_minimum
from kernels import kernel_calls
from planning.degenerate_games import GAMES
from random_games import random_game, random_turns


@pytest.fixture
def two_cores(monkeypatch):
    """Share out every programme, whatever this machine has."""
    monkeypatch.setattr(exact_minimum, "LARGE", 1)
    monkeypatch.setattr(exact_minimum.os, "cpu_count", lambda: 2)


@pytest.mark.usefixtures("two_cores")
@pytest.mark.parametrize("count", [4, 5, 6, 8, 11, 13])
def test_two_cores_find_what_one_finds(count):
    """Time and sequence, to the last bit."""
    generator = np.random.default_rng(count)
    for k in range(20):
        reach = {"radius": 0.1 * (k % 2), "capture_radius": 0.05 * (k % 3)}
        team, disk = random_game(generator, count, mixed=k % 4 == 0, **reach)
        assert_same_as_on_one(team, disk, random_turns(generator, count) * 0.5 ** (k % 4))


@pytest.mark.usefixtures("two_cores")
@pytest.mark.parametrize("name", [name for name, (team, _) in GAMES.items() if len(team) >= 4])
def test_two_cores_find_what_one_finds_where_sequences_tie(name):
    team, disk = GAMES[name]
    assert_same_as_on_one(team, disk, np.zeros(len(team)))


@pytest.mark.usefixtures("two_cores")
def test_a_team_that_stands_on_a_line():
    """One at 1 to the left first, then those to the right as they come: 1 + 1 + 5."""
    places = [(2.0, 0.0), (-1.0, 0.0), (5.0, 0.0), (3.0, 0.0), (4.0, 0.0)]
    team = covey.Team(places, [0.0] * 5, 0.0)
    guarantee = covey.guaranteed_survival(team, covey.PursuerDisk(), [0.0] * 5)
    assert guarantee.time == 7.0
    assert guarantee.sequence == (1, 0, 3, 4, 2)


def test_a_large_team():
    generator = np.random.default_rng(2)
    team, disk = random_game(generator, exact_minimum.LARGE)
    turns = random_turns(generator, len(team))
    assert_same_as_on_one(team, disk, turns)
    times = covey.capture_times(
        team, disk, turns, covey.guaranteed_survival(team, disk, turns).sequence
    )
    assert times[-1] == covey.guaranteed_survival(team, disk, turns).time


def assert_same_as_on_one(team, disk, turns):
    guarantee = covey.guaranteed_survival(team, disk, turns)
    time, sequence = kernel_calls.least(team, disk, turns)
    assert guarantee.time == time
    assert guarantee.sequence == tuple(sequence.tolist())
