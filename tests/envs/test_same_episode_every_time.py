"""A seed is a whole episode, to the last bit, whatever was played before it."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from gymnasium.utils.env_checker import data_equivalence

from covey.envs import pursuit_v0
from covey.envs.setup import TEAM
from envs.scripted_players import play_parallel, play_single, towards_nearest

SEEDS = range(30)
HIDDEN = {"sensing": "hidden", "disk_radius": 0.1, "capture_radius": 0.05}


def equal(one, other):
    return len(one) == len(other) and all(map(data_equivalence, one, other))


@pytest.mark.parametrize("sides", [{}, {"evaders": TEAM}], ids=["all", "pursuer_0"])
def test_parallel(sides):
    used = pursuit_v0.parallel_env(**sides, **HIDDEN)
    episodes = []
    for seed in SEEDS:
        fresh = pursuit_v0.parallel_env(**sides, **HIDDEN)
        first = play_parallel(fresh, np.random.default_rng(seed), seed=seed)
        again = play_parallel(used, np.random.default_rng(seed), seed=seed)
        assert equal(first, again)
        episodes.append(again)
    assert not any(equal(a, b) for a, b in itertools.pairwise(episodes))


@pytest.mark.parametrize("make", [pursuit_v0.PursuerEnv, pursuit_v0.TeamEnv])
def test_single(make):
    used = make(**HIDDEN)

    def play(env, seed):
        generator = np.random.default_rng(seed)
        if make is pursuit_v0.PursuerEnv:
            return play_single(env, lambda seen: towards_nearest(seen, 3), seed=seed)
        return play_single(env, lambda seen: generator.uniform(-1.0, 1.0, 3), seed=seed)

    for seed in SEEDS:
        assert equal(play(make(**HIDDEN), seed), play(used, seed))


def test_without_a_seed_games_go_on_from_the_last_one():
    one, other = pursuit_v0.PursuerEnv(), pursuit_v0.PursuerEnv()
    first, second = one.reset(seed=5)[0], one.reset()[0]
    assert not np.array_equal(first, second)
    other.reset(seed=5)
    np.testing.assert_array_equal(second, other.reset()[0])
