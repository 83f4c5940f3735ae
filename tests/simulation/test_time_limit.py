"""A game that is stopped says so, and is the beginning of the game that would have been."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.players.compiled import checked_settings
from random_games import random_game
from soak import custom_pursuers

BOTH = pytest.mark.parametrize("sensing", ["hidden", "visible"])


@BOTH
def test_it_is_the_beginning_of_the_whole_game(sensing):
    team, disk = random_game(np.random.default_rng(1), 5)
    whole = covey.simulate(team, disk, sensing=sensing, update_time=0.05)
    assert whole.status is covey.GameStatus.ALL_CAPTURED
    for captured in range(1, 5):
        limit = float(whole.capture_times[captured - 1 : captured + 1].mean())
        game = covey.simulate(team, disk, sensing=sensing, update_time=0.05, time_limit=limit)
        assert game.status is covey.GameStatus.TIME_LIMIT
        assert math.isinf(game.survival_time)
        assert game.capture_sequence.tolist() == whole.capture_sequence[:captured].tolist()
        assert game.capture_times.tolist() == whole.capture_times[:captured].tolist()
        assert game.times[-1] == limit
        assert game.times[:-1].tolist() == whole.times[: len(game.times) - 1].tolist()
        assert game.guarantee == whole.guarantee


@BOTH
def test_an_evader_that_is_captured_on_the_stroke_is_captured(sensing):
    team = covey.Team([(1.0, 0.0)], [0.0], speeds=0.0)
    game = covey.simulate(team, covey.PursuerDisk(), sensing=sensing, time_limit=1.0)
    assert game.status is covey.GameStatus.ALL_CAPTURED
    assert game.survival_time == pytest.approx(1.0, abs=1e-12)


@BOTH
def test_a_pursuer_that_never_comes_is_stopped_by_default(sensing):
    team, disk = random_game(np.random.default_rng(2), 2)
    game = covey.simulate(
        team, disk, pursuer=lambda situation: covey.Fly(), sensing=sensing, update_time=1.0
    )
    assert game.status is covey.GameStatus.TIME_LIMIT
    assert game.capture_sequence.shape == game.capture_times.shape == (0,)


@BOTH
@pytest.mark.parametrize("team_strategy", [covey.OpenLoop(2), covey.IterativeOpenLoop(2, 2)])
def test_a_committed_pursuer_is_done_long_before_the_default_limit(sensing, team_strategy):
    for seed in range(100):
        generator = np.random.default_rng(seed)
        team, disk = random_game(
            generator,
            1 + seed % 5,
            radius=generator.choice([0.0, 0.2]),
            capture_radius=generator.choice([0.0, 0.05]),
            mixed=seed % 2 == 1,
        )
        game = covey.simulate(
            team, disk, evaders=team_strategy, sensing=sensing, update_time=0.1, seed=seed
        )
        assert game.status is covey.GameStatus.ALL_CAPTURED, f"seed {seed}"


@BOTH
def test_whoever_keeps_one_order_is_done_by_the_default_limit(sensing):
    """Whatever the team does: this one turns at random."""
    for seed in range(20):
        team, disk = random_game(np.random.default_rng(seed), 4, mixed=True)
        game = covey.simulate(
            team,
            disk,
            evaders=lambda situation: np.random.default_rng(0).uniform(
                -3, 3, len(situation.evaders)
            ),
            pursuer=custom_pursuers.in_numerical_order(0),
            sensing=sensing,
            update_time=0.5,
        )
        assert game.status is covey.GameStatus.ALL_CAPTURED, f"seed {seed}"


DISK = covey.PursuerDisk(radius=10.0)
"""Much larger than the team's distance from its centre."""


@pytest.mark.parametrize("count", [1, 2, 4])
def test_a_pursuer_from_the_far_side_of_a_large_disk_is_done_by_the_default_limit(count):
    positions = [[1.0, 0.1 * i] for i in range(count)]
    game = covey.simulate(
        covey.Team(positions, np.zeros(count)),
        DISK,
        evaders=covey.HoldCourse(),
        pursuer=covey.FlyingPursuer(offset=(-1.0, 0.0)),
        sensing="visible",
        update_time=0.5,
    )
    assert game.status is covey.GameStatus.ALL_CAPTURED
    if count == 1:
        assert game.survival_time == pytest.approx((10.0 + 1.0) / 0.75, rel=1e-12)


def test_the_default_limit_by_hand():
    """An evader at d in a disk of radius r is caught within 2 (d + r) / (v_p - v) by then."""
    game = covey.simulate(
        covey.Team([[1.0, 0.0]], [0.0]),
        DISK,
        evaders=covey.HoldCourse(),
        pursuer=lambda situation: covey.Fly(),
        update_time=1.0,
    )
    assert game.status is covey.GameStatus.TIME_LIMIT
    assert game.times[-1] == pytest.approx(2.0 * (1.0 + 10.0) / 0.75, rel=1e-12)


def test_a_default_limit_too_large_for_a_number_is_none():
    team = covey.Team(np.ones((8, 2)), np.zeros(8), 1.0 - 2e-9)
    settings = checked_settings(
        team, covey.PursuerDisk(), "hidden", 0.1, 0, None, covey.LastCapture()
    )
    assert settings.time_limit == math.inf
