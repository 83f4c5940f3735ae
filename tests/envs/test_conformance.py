"""PettingZoo's and Gymnasium's own tests of an environment."""

from __future__ import annotations

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.wrappers.vector import RecordEpisodeStatistics

from covey.envs import pursuit_v0
from envs.scripted_players import towards_nearest

# PettingZoo's tests load an environment of its own in a way that it warns of.
pytestmark = pytest.mark.filterwarnings("ignore:The old environment creation API")

GAMES = [
    {},
    {"team_size": 1, "capture_radius": 0.3, "time_limit": 2.0},
    {
        "sensing": "hidden",
        "disk_radius": 0.2,
        "speed": [0.1, 0.5, 0.0],
        "turn_rate": [0.0, 9.0, np.inf],
    },
]
each_game = pytest.mark.parametrize("game", GAMES, ids=["default", "one", "mixed"])


@pytest.fixture
def petting_zoo():
    from pettingzoo import test

    return test


@each_game
def test_petting_zoo_parallel(petting_zoo, game):
    petting_zoo.parallel_api_test(pursuit_v0.parallel_env(**game), num_cycles=300)


def test_petting_zoo_turn_by_turn(petting_zoo):
    petting_zoo.api_test(pursuit_v0.env(), num_cycles=200)


@each_game
def test_petting_zoo_seeds(petting_zoo, game):
    petting_zoo.parallel_seed_test(lambda: pursuit_v0.parallel_env(**game), num_cycles=100)


def test_petting_zoo_pictures(petting_zoo, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")  # a window on no screen
    petting_zoo.render_test(pursuit_v0.env)


@each_game
@pytest.mark.parametrize("name", ["covey/Pursuer-v0", "covey/Team-v0"])
def test_gymnasium(name, game, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    check_env(gymnasium.make(name, **game).unwrapped)


@pytest.mark.parametrize("name", ["covey/Pursuer-v0", "covey/Team-v0"])
def test_gymnasium_batches(name):
    games = gymnasium.make_vec(name, 3, "vector_entry_point", capture_radius=0.1, time_limit=3.0)
    games = RecordEpisodeStatistics(games)
    seen, _ = games.reset(seed=1)
    assert seen in games.observation_space
    finished = 0
    while finished < 6:
        actions = games.action_space.sample()
        if name == "covey/Pursuer-v0":
            actions = towards_nearest(seen, 3)
        seen, _, ended, late, infos = games.step(actions)
        assert seen in games.observation_space
        for b in np.flatnonzero(ended | late):
            finished += 1
            length = abs(infos["episode"]["r"][b])
            assert length == pytest.approx(infos["final_info"]["time"][b], rel=1e-6)
    games.close()
