"""How many steps a second environments make, kernels compiled, one core. Run with `make bench`.

Everything that a learner waits for counts: resets with their plans, checks, observations. Evaders
are counted while they live.
"""

from __future__ import annotations

import time

import numpy as np
import pytest

import covey
from covey.envs import pursuit_v0
from covey.envs.setup import TEAM

GAMES, STEPS, ROUNDS = 64, 200, 5
SIZES = (2, 3, 5, 8)


def towards_nearest(seen, size):
    """Directions (B, 2) to the nearest evader alive."""
    rows = seen[:, :-3].reshape(GAMES, size, 6)
    distances = np.where(rows[..., 5] > 0.0, np.hypot(rows[..., 0], rows[..., 1]), np.inf)
    return rows[np.arange(GAMES), distances.argmin(axis=1), :2]


def measure(benchmark, games, decide):
    size, seconds, flown = games.setup.team_size, [], []

    def play():
        seen, _ = games.reset(seed=0)
        alive, begun = 0.0, time.process_time()
        for _ in range(STEPS):
            alive += float(seen[:, 5 : 6 * size : 6].sum())
            seen, *_ = games.step(decide(seen, size))
        seconds.append(time.process_time() - begun)
        flown.append(alive)

    benchmark.pedantic(play, rounds=ROUNDS, warmup_rounds=1)
    benchmark.extra_info["evader-steps per second of processor time"] = round(
        max(np.divide(flown, seconds))
    )
    print(f"\n{games}, N = {size}: {max(np.divide(flown, seconds)):,.0f} evader-steps a second")


@pytest.mark.parametrize(
    "team", [TEAM, covey.OpenLoop(starts=8)], ids=lambda team: type(team).__name__
)
@pytest.mark.parametrize("size", SIZES)
def test_pursuers_against_planning_teams(benchmark, size, team):
    benchmark.group = "batch of pursuers"
    games = pursuit_v0.PursuerVectorEnv(GAMES, team_size=size, evaders=team)
    measure(benchmark, games, towards_nearest)


@pytest.mark.parametrize("size", SIZES)
def test_teams_against_committed_pursuers(benchmark, size):
    generator = np.random.default_rng(0)
    benchmark.group = "batch of teams"
    games = pursuit_v0.TeamVectorEnv(GAMES, team_size=size)
    measure(benchmark, games, lambda seen, size: generator.uniform(-1.0, 1.0, (GAMES, size)))


@pytest.mark.parametrize("size", SIZES)
def test_one_game_in_python(benchmark, size):
    """A step of the PettingZoo environment, all agents ours, resets included."""
    env, generator = pursuit_v0.parallel_env(team_size=size), np.random.default_rng(0)
    env.reset(seed=0)

    def step():
        if not env.agents:
            env.reset()
        actions = {agent: generator.uniform(-1.0, 1.0, 1) for agent in env.agents}
        actions["pursuer_0"] = [1.0, 0.0]
        env.step(actions)

    benchmark.group = "one parallel environment, one step"
    benchmark.pedantic(step, rounds=500, warmup_rounds=20)
