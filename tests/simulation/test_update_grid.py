"""Where updates fall changes nothing for a team that plans once: captures have exact times."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from random_games import random_game

ROUNDING = 1e-9
"""Of a time, in games of about unit size, that is added up from hundreds of intervals."""
UPDATE_TIMES = (0.003, 0.01, 0.05, 1.0)


def games_of_a_plan(sensing, radius, reach):
    """A plan and an order of capture, and what became of them for each time between updates."""
    for seed in range(6):
        generator = np.random.default_rng([seed, round(100 * radius), round(100 * reach)])
        count = 1 + seed % 5
        team, disk = random_game(
            generator, count, radius=radius, capture_radius=reach, mixed=seed % 2 == 1
        )
        order = generator.permutation(count)
        played = [
            covey.simulate(
                team,
                disk,
                evaders=covey.OpenLoop(starts=2),
                pursuer=covey.FixedSequence(order),
                sensing=sensing,
                update_time=update_time,
                seed=seed,
            )
            for update_time in UPDATE_TIMES
        ]
        turns = covey.plan(team, disk, seed=seed, starts=2).turns
        yield played, covey.capture_times(team, disk, turns, order)


@pytest.mark.parametrize("radius", [0.0, 0.2])
@pytest.mark.parametrize("reach", [0.0, 0.05])
def test_a_hidden_pursuer_needs_what_algorithm_1_says(radius, reach):
    for played, expected in games_of_a_plan("hidden", radius, reach):
        for game in played:
            assert game.capture_times == pytest.approx(expected, abs=ROUNDING)


@pytest.mark.parametrize("radius", [0.0, 0.2])
def test_so_does_a_visible_one_without_reach(radius):
    for played, expected in games_of_a_plan("visible", radius, 0.0):
        for game in played:
            assert game.capture_times == pytest.approx(expected, abs=ROUNDING)


@pytest.mark.parametrize("radius", [0.0, 0.2])
def test_a_visible_one_with_reach_needs_longer_but_always_the_same(radius):
    """It is somewhere in particular within reach of whom it took, and takes others on its way."""
    for played, _ in games_of_a_plan("visible", radius, 0.05):
        first, *others = played
        assert first.survival_time >= first.guarantee - ROUNDING
        for game in others:
            assert game.capture_sequence.tolist() == first.capture_sequence.tolist()
            assert game.capture_times == pytest.approx(first.capture_times, abs=ROUNDING)
