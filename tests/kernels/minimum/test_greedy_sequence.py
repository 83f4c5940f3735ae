"""The sequence whose time is the first bound of the exact search, and what that bound changes."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from kernels import kernel_calls
from random_games import random_game, random_turns


@pytest.mark.parametrize("mixed", [False, True])
@pytest.mark.parametrize("count", [1, 2, 9, 10, 14, 18])
def test_is_a_sequence_with_its_times(count, mixed):
    generator = np.random.default_rng([count, mixed])
    for _ in range(20):
        team, disk = random_game(generator, count, radius=0.1, capture_radius=0.02, mixed=mixed)
        turns = random_turns(generator, count)
        order, times = kernel_calls.greedy(team, disk, turns)
        assert times.tolist() == covey.capture_times(team, disk, turns, order).tolist()
        assert times[-1] <= kernel_calls.nearest(team, disk, turns)


def test_is_much_shorter_than_nearest_first():
    """What nearest first takes too long is more than halved, in the mean of some games."""
    generator = np.random.default_rng(16)
    excess = []
    for _ in range(12):
        team, disk = random_game(generator, 16)
        turns = 0.15 * random_turns(generator, 16)
        least = covey.guaranteed_survival(team, disk, turns).time
        short = kernel_calls.greedy(team, disk, turns)[1][-1]
        excess.append((kernel_calls.nearest(team, disk, turns) / least - 1.0, short / least - 1.0))
    nearest, short = np.mean(excess, axis=0)
    assert short < 0.5 * nearest


@pytest.mark.parametrize("reach", [0.0, 0.02])
@pytest.mark.parametrize("mixed", [False, True])
@pytest.mark.parametrize("count", [10, 12, 14])
def test_the_least_time_is_the_same_without_it(count, mixed, reach):
    """A loose bound takes its place."""
    generator = np.random.default_rng([count, mixed, round(100 * reach)])
    for _ in range(5):
        team, disk = random_game(generator, count, capture_radius=reach, mixed=mixed)
        turns = random_turns(generator, count)
        least, sequence = kernel_calls.least(team, disk, turns)
        again, found = kernel_calls.least(team, disk, turns, 1.7 * least)
        assert again == least
        assert found.tolist() == sequence.tolist()


@pytest.mark.parametrize("count", [10, 12, 14])
def test_tied_sequences_do_not_matter(count):
    """A ring that flies apart, in which every order around it takes as long as its mirror image."""
    angles = np.arange(count) * 2.0 * math.pi / count
    places = 0.4 * np.column_stack([np.cos(angles), np.sin(angles)])
    team, disk = covey.Team(places, angles), covey.PursuerDisk()
    for turns in (np.zeros(count), np.full(count, 0.3)):
        least, sequence = kernel_calls.least(team, disk, turns)
        assert kernel_calls.least(team, disk, turns, 1.7 * least)[0] == least
        assert covey.capture_times(team, disk, turns, sequence)[-1] == least
