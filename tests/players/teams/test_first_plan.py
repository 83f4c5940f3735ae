"""A game begins with the plan that `covey.plan` finds, to the last bit."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from random_games import random_game

STARTS = 3

TEAMS = [covey.OpenLoop(starts=STARTS), covey.IterativeOpenLoop(starts=STARTS, restarts=2)]


@pytest.mark.parametrize("evaders", TEAMS, ids=lambda team: type(team).__name__)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_the_guarantee_is_the_plans_value(evaders, compiled, sensing):
    for seed in range(24):
        team, disk = random_game(
            np.random.default_rng(seed),
            1 + seed % 6,
            radius=0.1 * (seed % 2),
            capture_radius=0.02 * (seed % 3),
            mixed=seed % 4 > 1,
        )
        game = covey.simulate(
            team,
            disk,
            evaders=evaders if compiled else evaders.start(seed),
            sensing=sensing,
            seed=seed,
            time_limit=0.05,
        )
        plan = covey.plan(team, disk, seed=seed, starts=STARTS)
        assert game.guarantee == plan.survival_time == game.guarantees[0]
        assert np.array_equal(game.evader_turns[0], plan.turns)
        assert tuple(game.critical_sequences[0]) == plan.critical_sequences[0]
        assert np.array_equal(game.evader_headings[0], team.headings)
        assert np.array_equal(game.evader_positions[0], team.positions)


def test_by_default_it_is_the_default_plan():
    team, disk = random_game(np.random.default_rng(0), 5)
    game = covey.simulate(team, disk, time_limit=0.05)
    assert game.guarantee == covey.plan(team, disk).survival_time
