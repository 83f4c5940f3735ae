"""An episode of an environment and a game of `covey.simulate` are one game.

Each test plays one of the two, writes down what was decided, and plays that in the other.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.envs import pursuit_v0
from covey.envs.setup import TEAM

GAME = {"team_size": 3, "capture_radius": 0.03, "update_time": 0.05}
SEEDS = range(8)
CLOSE = {"rtol": 0.0, "atol": 1e-9}


class Seeded:
    """A strategy that plans with a seed of the test's, whichever the environment draws."""

    def __init__(self, strategy, seed):
        self.strategy, self.seed = strategy, seed

    def start(self, seed):
        return self.strategy.start(self.seed)


def start_of(seed, count=3):
    generator = np.random.default_rng(seed)
    positions = generator.uniform(-0.5, 0.5, (count, 2))
    return positions, generator.uniform(-math.pi, math.pi, count)


def game_of(seed, turn_rate=math.pi / 2, reach=0.03):
    positions, headings = start_of(seed)
    team = covey.Team(positions, headings, 0.25, turn_rate)
    return team, covey.PursuerDisk(capture_radius=reach)


def options_of(seed):
    positions, headings = start_of(seed)
    return {"positions": positions, "headings": headings}


def captures(env):
    """The order and times of captures while an environment is stepped; a generator of tests."""
    living = set(env.unwrapped._episode.living.tolist())
    return living


def assert_same(record, order, times):
    assert order == record.capture_sequence.tolist()
    np.testing.assert_allclose(times, record.capture_times, **CLOSE)


def headings_flown(record):
    """The direction in which the pursuer of a record flew after each row."""
    return np.diff(record.pursuer_positions, axis=0)


@pytest.mark.parametrize("turn_rate", [math.pi / 2, 40.0, math.inf, 0.0])
@pytest.mark.parametrize("seed", SEEDS)
def test_any_actions_of_both_sides(seed, turn_rate):
    """Random steering against a pursuer that reels towards somebody, replayed by `simulate`."""
    env = pursuit_v0.parallel_env(turn_rate=turn_rate, **GAME)
    generator = np.random.default_rng(seed)
    seen, _ = env.reset(seed=seed, options=options_of(seed))
    turns, velocities, order, times = [], [], [], []
    largest = min(turn_rate * 0.05, math.pi)
    while env.agents:
        actions = {agent: generator.uniform(-1.0, 1.0, 1) for agent in env.agents}
        living = np.flatnonzero(seen["pursuer"][5:18:6])
        target = seen["pursuer"][6 * living[0] :][:2] + generator.normal(0.0, 0.1, 2)
        actions["pursuer"] = target
        turns.append([float(actions[f"evader_{i}"][0]) * largest for i in living])
        velocities.append(tuple(target / np.hypot(*target)))
        seen, _, out, _, infos = env.step(actions)
        for i in living:
            if out[f"evader_{i}"]:
                order.append(int(i))
                times.append(infos["pursuer"]["time"])

    team, disk = game_of(seed, turn_rate)
    told = iter(turns), iter(velocities)
    record = covey.simulate(
        team,
        disk,
        evaders=lambda situation: next(told[0]),
        pursuer=lambda situation: covey.Fly(next(told[1])),
        sensing="visible",
        update_time=0.05,
        time_limit=20.0,
    )
    assert_same(record, order, times)
    assert len(times) == 3


def step_through(env, actions_of):
    """Order and times of the captures of a single view; `actions_of` row after row."""
    living, order, times, row = [0, 1, 2], [], [], 0
    over = False
    while not over:
        _, _, ended, late, info = env.step(actions_of(row))
        row += 1
        still = env._episode.living.tolist()
        order += [i for i in living if i not in still]
        times += [info["time"]] * (len(living) - len(still))
        living, over = still, ended or late
    return order, times


@pytest.mark.parametrize("strategy", [TEAM, covey.OpenLoop(starts=4)])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_pursuer_that_flies_as_the_committed_one_did(strategy, seed):
    team, disk = game_of(seed)
    record = covey.simulate(
        team, disk, evaders=strategy, sensing="visible", update_time=0.05, seed=7
    )
    flown = headings_flown(record)
    env = pursuit_v0.PursuerEnv(evaders=Seeded(strategy, 7), **GAME)
    _, info = env.reset(seed=seed, options=options_of(seed))
    assert info["guarantee"] == pytest.approx(record.guarantee, abs=1e-12)
    assert_same(record, *step_through(env, lambda row: flown[row]))


@pytest.mark.parametrize("pursuer", [covey.CommittedPursuer(), covey.FixedSequence([2, 0, 1])])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_team_that_steers_at_random(pursuer, seed):
    generator = np.random.default_rng(seed)
    shares = generator.uniform(-1.0, 1.0, (400, 3))
    rows = iter(shares)
    team, disk = game_of(seed)
    record = covey.simulate(
        team,
        disk,
        evaders=lambda situation: next(rows)[list(situation.evaders)] * (math.pi / 2 * 0.05),
        pursuer=pursuer,
        sensing="visible",
        update_time=0.05,
        time_limit=20.0,
    )
    env = pursuit_v0.TeamEnv(pursuer=pursuer, **GAME)
    env.reset(seed=seed, options=options_of(seed))
    assert_same(record, *step_through(env, lambda row: shares[row]))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_whole_game_of_two_strategies_replayed_by_all_agents(seed):
    """Plans that are turned into turn rates are flown exactly, also where a turn ends in a step."""
    team, disk = game_of(seed)
    record = covey.simulate(
        team, disk, evaders=TEAM, sensing="visible", update_time=0.05, seed=seed
    )
    shares = np.clip(record.evader_turns / (math.pi / 2 * 0.05), -1.0, 1.0)
    flown = headings_flown(record)
    env = pursuit_v0.parallel_env(**GAME)
    env.reset(seed=seed, options=options_of(seed))
    order, times, row = [], [], 0
    while env.agents:
        actions = {f"evader_{i}": shares[row, [i]] for i in range(3)} | {"pursuer": flown[row]}
        _, _, out, _, infos = env.step({agent: actions[agent] for agent in env.agents})
        captured = [i for i in range(3) if out.get(f"evader_{i}")]
        order += captured
        times += [infos["pursuer"]["time"]] * len(captured)
        row += 1
    assert_same(record, order, times)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_hidden_pursuer_with_hardly_any_reach_is_the_disk_of_the_simulation(seed):
    """What a real pursuer can't do, and the simulation's can, is to be anywhere within ρ at once."""
    reach, strategy = 1e-12, covey.OpenLoop(starts=4)
    team, disk = game_of(seed, reach=reach)
    record = covey.simulate(
        team,
        disk,
        evaders=strategy,
        pursuer=covey.FixedSequence([1, 2, 0]),
        sensing="hidden",
        update_time=0.05,
        seed=7,
    )
    env = pursuit_v0.parallel_env(
        evaders=Seeded(strategy, 7), sensing="hidden", **(GAME | {"capture_radius": reach})
    )
    del env
    single = pursuit_v0.PursuerEnv(
        evaders=Seeded(strategy, 7), sensing="hidden", **(GAME | {"capture_radius": reach})
    )
    single.reset(seed=seed, options=options_of(seed))
    flown = headings_flown(record)
    assert_same(record, *step_through(single, lambda row: flown[min(row, len(flown) - 1)]))
