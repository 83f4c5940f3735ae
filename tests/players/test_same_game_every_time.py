"""A seed settles a game, to the last bit, and settles nothing else."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from random_games import random_game
from soak import custom_pursuers
from soak.same_games import differences


def five(seed):
    return random_game(np.random.default_rng(seed), 5, mixed=True)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_the_same_call_gives_the_same_game(sensing, seed):
    def play():
        return covey.simulate(*five(seed), sensing=sensing, update_time=0.05, seed=seed)

    assert differences(play(), play()) == []


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_the_same_call_gives_the_same_game_with_ones_own_strategy(sensing):
    def play():
        pursuer = custom_pursuers.redrawing(7)
        return covey.simulate(*five(3), pursuer=pursuer, sensing=sensing, update_time=0.05, seed=3)

    assert differences(play(), play()) == []


def test_strategies_are_values_that_games_leave_alone():
    """One strategy plays two games as two would."""
    evaders, pursuer = covey.IterativeOpenLoop(starts=2), covey.CommittedPursuer()

    def play(evaders, pursuer):
        return covey.simulate(*five(5), evaders=evaders, pursuer=pursuer, update_time=0.05)

    covey.simulate(*five(4), evaders=evaders, pursuer=pursuer, update_time=0.05)
    again = play(evaders, pursuer)
    assert (
        differences(again, play(covey.IterativeOpenLoop(starts=2), covey.CommittedPursuer())) == []
    )


def test_another_seed_searches_elsewhere():
    """With few starts, some games have another plan."""
    guarantees = [
        [covey.simulate(*five(k), seed=seed, time_limit=0.1).guarantee for k in range(10)]
        for seed in (0, 1)
    ]
    assert guarantees[0] != guarantees[1]
