"""Rewards are the survival time, zero-sum, and never less than what was guaranteed."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.envs import pursuit_v0
from covey.envs.setup import TEAM
from envs.scripted_players import play_parallel, play_single, towards_nearest


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_zero_sum_and_the_survival_time(sensing):
    env = pursuit_v0.parallel_env(sensing=sensing)
    for seed in range(10):
        _, *steps = play_parallel(env, np.random.default_rng(seed), seed=seed)
        total, alive = dict.fromkeys(env.possible_agents, 0.0), 3
        for _, rewards, out, _, _ in steps:
            assert math.fsum(rewards.values()) == pytest.approx(0.0, abs=1e-15)
            for agent, reward in rewards.items():
                total[agent] += reward
            alive -= sum(out[agent] for agent in out if agent != "pursuer_0")
            assert out["pursuer_0"] == (alive == 0)
            assert len([agent for agent in rewards if agent != "pursuer_0"]) >= alive
        *_, late, infos = steps[-1]
        assert -total["pursuer_0"] == pytest.approx(infos["pursuer_0"]["time"], rel=1e-12)
        assert any(late.values()) != (alive == 0)


def test_a_late_game_is_truncated_and_not_terminated():
    env = pursuit_v0.PursuerEnv(time_limit=0.12)
    *_, (_, _, ended, late, info) = play_single(env, lambda seen: [0.0, 0.0], seed=1)
    assert (ended, late) == (False, True)
    assert info["time"] == pytest.approx(0.12, abs=1e-15)


@pytest.mark.parametrize("team", [TEAM, covey.OpenLoop(starts=4)])
@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_a_planning_team_survives_what_it_was_guaranteed(team, sensing):
    """Against pursuers that aim at the nearest, with more and less of a tremor."""
    env = pursuit_v0.PursuerEnv(evaders=team, sensing=sensing, headings="random", disk_radius=0.1)
    closest = math.inf
    for seed in range(25):
        generator = np.random.default_rng(seed)

        def decide(seen, generator=generator):
            return towards_nearest(seen, 3) + generator.normal(0.0, 0.02, 2)

        *_, (_, _, _, _, info) = play_single(env, decide, seed=seed)
        assert info["time"] >= info["guarantee"] - 1e-9
        closest = min(closest, info["time"] / info["guarantee"])
    assert closest < 1.2  # or the guarantee were tested by nobody


def test_the_guarantee_of_a_team_that_does_not_plan_is_that_of_a_plan():
    env = pursuit_v0.TeamEnv()
    start = {"positions": [[0.3, 0.1], [0.0, 0.4], [-0.2, -0.2]], "headings": [0.0, 1.0, 2.0]}
    _, info = env.reset(seed=0, options=start)
    disk = covey.PursuerDisk(capture_radius=0.02)
    best = covey.plan(covey.Team(**start), disk, starts=64).survival_time
    assert 0.98 * best < info["guarantee"] <= best * (1.0 + 1e-9)


@pytest.mark.parametrize("pursuer", [covey.CommittedPursuer(), None])
def test_only_sides_without_a_strategy_are_agents(pursuer):
    env = pursuit_v0.parallel_env(pursuer=pursuer)
    evaders = [f"evader_{i}" for i in range(3)]
    assert env.possible_agents == evaders + ([] if pursuer else ["pursuer_0"])
    *_, (_, _, out, _, _) = play_parallel(env, np.random.default_rng(0), seed=0)
    assert all(out.values())
    assert env.agents == []
    assert env.step({}) == ({}, {}, {}, {}, {})
