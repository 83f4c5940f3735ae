"""Observations: by hand, always inside their space, and no more than the rules allow."""

from __future__ import annotations

import math

import numpy as np
import pytest

from covey.envs import pursuit_v0
from envs.scripted_players import play_parallel, rows_of

START = {"positions": [[0.3, 0.0], [0.0, 0.4]], "headings": [0.0, math.pi / 2]}
TWO = {"team_size": 2, "capture_radius": 0.05, "update_time": 0.1}


def test_by_hand():
    env = pursuit_v0.parallel_env(**TWO, speed=[0.2, 0.1], turn_rate=[1.0, math.inf])
    seen, _ = env.reset(options=START)
    first, second = [0.3, 0.0, 0.2, 0.0, 0.0, 1.0], [0.0, 0.4, 0.0, 0.1, 0.0, 1.0]
    np.testing.assert_allclose(seen["pursuer_0"], [*first, *second, 0.0, 0.0, 0.0], atol=1e-7)
    own, other = [0.0, 0.0, 0.0, 0.1, 0.0, 1.0], [0.3, -0.4, 0.2, 0.0, 0.0, 1.0]
    np.testing.assert_allclose(seen["evader_1"], [*own, *other, 0.0, -0.4, 0.0], atol=1e-7)

    # The pursuer waits, evader 0 flies straight, evader 1 turns back at once.
    seen, *_ = env.step({"pursuer_0": [0.0, 0.0], "evader_0": [0.0], "evader_1": [1.0]})
    rows = rows_of(seen["pursuer_0"], 2)
    np.testing.assert_allclose(rows[0], [0.32, 0.0, 0.2, 0.0, 0.0, 1.0], atol=1e-7)
    np.testing.assert_allclose(rows[1], [0.0, 0.39, 0.0, -0.1, 0.0, 1.0], atol=1e-7)

    # Half the largest turn rate, for a whole step.
    seen, *_ = env.step({"pursuer_0": [0.0, 0.0], "evader_0": [0.5], "evader_1": [0.0]})
    heading = math.atan2(*rows_of(seen["pursuer_0"], 2)[0, [3, 2]])
    assert heading == pytest.approx(0.05, abs=1e-6)


def test_a_capture_in_the_middle_of_a_step_ends_it():
    env = pursuit_v0.parallel_env(**TWO, speed=0.2)
    env.reset(options=START)
    time, out = 0.0, {}
    while not out.get("evader_0"):
        steer = {agent: [0.0] for agent in env.agents} | {"pursuer_0": [7.0, 0.0]}
        seen, rewards, out, _, infos = env.step(steer)
        assert rewards["pursuer_0"] == pytest.approx(time - infos["pursuer_0"]["time"])
        time = infos["pursuer_0"]["time"]
    assert time == pytest.approx((0.3 - 0.05) / (1.0 - 0.2), abs=1e-12)
    assert env.agents == ["evader_1", "pursuer_0"]
    assert not seen["pursuer_0"][:6].any()
    assert not seen["evader_0"][:6].any()


def test_plans_are_announced_to_the_pursuer():
    team = lambda situation: np.full(len(situation.evaders), 0.7)  # noqa: E731
    seen, _ = pursuit_v0.PursuerEnv(evaders=team, **TWO).reset(seed=1)
    np.testing.assert_allclose(rows_of(seen, 2)[:, 4], 0.7, rtol=1e-6)


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
@pytest.mark.parametrize("seed", range(5))
def test_always_inside_the_space(seed, sensing):
    generator = np.random.default_rng(seed)
    env = pursuit_v0.parallel_env(
        sensing=sensing,
        speed=[0.0, 0.99, 0.5],
        turn_rate=[math.inf, 0.0, 3.0],
        disk_radius=0.3,
        headings="random",
        time_limit=6.0,
    )
    for returned in play_parallel(env, generator, seed=seed):
        for agent, seen in returned[0].items():
            assert seen in env.observation_space(agent)


def test_farthest_apart_is_still_inside():
    """Corner to corner, everybody straight away from everybody, to the time limit."""
    env = pursuit_v0.parallel_env(**TWO, speed=0.99, time_limit=20.0)
    corners = {"positions": [[0.5, 0.5], [-0.5, -0.5]], "headings": [math.pi / 4, -0.75 * math.pi]}
    env.reset(options=corners)
    while env.agents:
        actions = {"evader_0": [0.0], "evader_1": [0.0], "pursuer_0": [-1.0, -1.0]}
        seen, *_ = env.step({agent: actions[agent] for agent in env.agents})
        for agent in seen:
            assert seen[agent] in env.observation_space(agent)


def test_hidden_evaders_see_a_disk_and_nothing_of_the_flight_in_it():
    flights = [[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]]
    env = pursuit_v0.parallel_env(sensing="hidden", **TWO)
    told = []
    for flight in flights:
        seen, _ = env.reset(seed=3, options=START)
        for step in range(1, 3):
            steer = {"evader_0": [0.3], "evader_1": [-1.0], "pursuer_0": flight}
            seen, *_ = env.step(steer)
            radius = seen["evader_0"][-1]
            assert radius == pytest.approx(0.1 * step, rel=1e-6)
        told.append(seen)
    for agent in ("evader_0", "evader_1"):
        np.testing.assert_array_equal(told[0][agent], told[1][agent])
        np.testing.assert_array_equal(told[0][agent], told[2][agent])
    assert not np.array_equal(told[0]["pursuer_0"], told[1]["pursuer_0"])


def test_a_hidden_pursuer_is_always_inside_its_disk():
    env = pursuit_v0.parallel_env(sensing="hidden", disk_radius=0.2)
    collapsed = 0
    for seed in range(10):
        for seen, *_ in play_parallel(env, np.random.default_rng(seed), seed=seed):
            x, y, radius = seen["pursuer_0"][-3:]
            assert math.hypot(x, y) <= radius + 1e-6
            collapsed += radius == np.float32(0.02)
    assert collapsed >= 20
