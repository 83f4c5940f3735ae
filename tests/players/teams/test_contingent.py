"""A team that answers captures, in games: it survives what its first plan promised."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from random_games import random_game

PURSUERS = [
    covey.CommittedPursuer(),
    covey.UncommittedPursuer(),
    covey.BestSequence(),
    covey.NearestFirst(),
    covey.FlyingPursuer(offset=(0.0, 0.0)),
]


@pytest.mark.parametrize("pursuer", PURSUERS, ids=lambda each: each.describe()["name"])
@pytest.mark.parametrize("depth", [None, 1])
def test_the_first_promise_is_kept(pursuer, depth):
    for seed in range(4):
        team, disk = random_game(np.random.default_rng(seed), 3, capture_radius=0.01 * (seed % 2))
        promised = covey.plan_contingent(team, disk, depth).with_delays.survival_time
        sensing = "visible" if seed % 2 else "hidden"
        game = covey.simulate(
            team,
            disk,
            evaders=covey.Contingent(depth),
            pursuer=pursuer,
            sensing=sensing,
            update_time=0.05,
        )
        assert game.survival_time >= promised * (1.0 - 1e-9)


def test_with_its_answers_a_team_survives_longer():
    gains = []
    for seed in range(6):
        team, disk = random_game(np.random.default_rng(seed), 4)
        games = [
            covey.simulate(team, disk, evaders=each, update_time=0.05)
            for each in (covey.IterativeOpenLoop(), covey.Contingent())
        ]
        gains.append(games[1].survival_time / games[0].survival_time)
    assert np.mean(gains) > 1.0


def test_a_depth_of_0_is_an_open_loop_plan_at_first():
    team, disk = random_game(np.random.default_rng(1), 3)
    game = covey.simulate(team, disk, evaders=covey.Contingent(0), update_time=0.1)
    assert game.guarantees[0] == pytest.approx(covey.plan(team, disk).survival_time)


def test_it_is_described_by_its_name_and_parameters():
    assert covey.Contingent().describe() == {"name": "contingent", "replan_time": 0.0}
    assert covey.Contingent(2).describe()["depth"] == 2
    with pytest.raises(covey.InputError, match=r"Contingent\.depth"):
        covey.Contingent(-1)
