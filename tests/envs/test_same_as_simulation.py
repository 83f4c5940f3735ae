"""An episode of an environment and a game of `covey.simulate` are one game.

Each test plays one of the two, writes down what was decided, and plays that in the other.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.envs import pursuit_v0
from covey.envs.episode import Episode
from covey.envs.setup import TEAM, InitialState, Setup

DT, RATE, REACH = 0.05, math.pi / 2, 0.03
GAME = {"capture_radius": REACH, "update_time": DT}
SEEN = {"sensing": "visible", "update_time": DT, "time_limit": 20.0}
SEEDS = range(6)
TEAMS = [
    TEAM,
    covey.OpenLoop(starts=4),
    covey.Contingent(depth=1),
    covey.ConstantHeading(starts=2, restarts=1),
    covey.KnownSequence(replan_time=0.5),
    covey.LargestDistance(replan_time=0.2),
    covey.SmallestDanger(replan_time=0.2),
    covey.StraightAway(),
    covey.HoldCourse(),
]


class Seeded:
    """A strategy that plans with a seed of the test's, whichever the environment draws."""

    def __init__(self, strategy, seed):
        self.strategy, self.seed = strategy, seed

    def start(self, seed):
        return self.strategy.start(self.seed)


class InTheMiddle:
    """A pursuer's strategy, played from the middle of the disk."""

    def __init__(self, strategy):
        self.strategy = strategy

    def start(self, seed):
        return self.strategy.start(seed)

    def place(self, disk):
        return disk.center


def options_of(seed):
    generator = np.random.default_rng(seed)
    positions = generator.uniform(-0.5, 0.5, (3, 2))
    return {"positions": positions, "headings": generator.uniform(-math.pi, math.pi, 3)}


def game_of(seed, turn_rate=RATE, reach=REACH):
    team = covey.Team(**options_of(seed), speeds=0.25, turn_rates=turn_rate)
    return team, covey.PursuerDisk(capture_radius=reach)


def assert_same(record, captures):
    assert len(captures) == 3
    assert [i for i, _ in captures] == record.capture_sequence.tolist()
    np.testing.assert_allclose([t for _, t in captures], record.capture_times, rtol=0.0, atol=1e-9)


def directions_of(record):
    """Where the pursuer of a record flew to after each row."""
    return np.diff(record.pursuer_positions, axis=0)


def captures_of_one_side(env, action_of):
    """Captures (evader, time) of a single view; `action_of` row."""
    captures, living, row, over = [], {0, 1, 2}, 0, False
    while not over:
        seen, _, ended, late, info = env.step(action_of(row))
        still = {i for i in range(3) if seen[6 * i + 5] > 0.0}
        captures += [(i, info["time"]) for i in living - still]
        living, over, row = still, ended or late, row + 1
    return captures


def captures_of_strategies(sensing, reach, seed, evaders, pursuer):
    """Captures (evader, time) of an episode in which nobody is left to agents."""
    setup = Setup(sensing=sensing, update_time=DT, capture_radius=reach)
    start = InitialState(**options_of(seed), pursuer=np.zeros(2))
    episode, captures = Episode(setup, start, 7, evaders, pursuer), []
    while not (episode.ended or episode.late):
        before = set(episode.living.tolist())
        episode.step(None, None)
        captures += [(i, episode.time) for i in before - set(episode.living.tolist())]
    return captures


@pytest.mark.parametrize("turn_rate", [RATE, 40.0, math.inf, 0.0])
@pytest.mark.parametrize("seed", SEEDS)
def test_any_actions_of_both_sides(seed, turn_rate):
    """Random steering and a pursuer that reels towards somebody, told to `simulate` afterwards."""
    env = pursuit_v0.parallel_env(turn_rate=turn_rate, **GAME)
    generator = np.random.default_rng(seed)
    seen, _ = env.reset(seed=seed, options=options_of(seed))
    turns, velocities, captures = [], [], []
    while env.agents:
        actions = {agent: generator.uniform(-1.0, 1.0, 1) for agent in env.agents}
        living = np.flatnonzero(seen["pursuer_0"][5:18:6]).tolist()
        target = seen["pursuer_0"][6 * living[0] :][:2] + generator.normal(0.0, 0.1, 2)
        actions["pursuer_0"] = target
        largest = min(turn_rate * DT, math.pi)
        turns.append([actions[f"evader_{i}"][0] * largest for i in living])
        velocities.append(tuple(target / np.hypot(*target)))
        seen, _, out, _, infos = env.step(actions)
        captures += [(i, infos["pursuer_0"]["time"]) for i in living if out[f"evader_{i}"]]

    told_turns, told_velocities = iter(turns), iter(velocities)
    record = covey.simulate(
        *game_of(seed, turn_rate),
        evaders=lambda situation: next(told_turns),
        pursuer=lambda situation: covey.Fly(next(told_velocities)),
        **SEEN,
    )
    assert_same(record, captures)


@pytest.mark.parametrize("strategy", [TEAM, covey.OpenLoop(starts=4)])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_pursuer_that_flies_as_the_committed_one_did(strategy, seed):
    record = covey.simulate(*game_of(seed), evaders=strategy, seed=7, **SEEN)
    flown = directions_of(record)
    env = pursuit_v0.PursuerEnv(evaders=Seeded(strategy, 7), **GAME)
    _, info = env.reset(seed=seed, options=options_of(seed))
    assert info["guarantee"] == pytest.approx(record.guarantee, abs=1e-12)
    assert_same(record, captures_of_one_side(env, lambda row: flown[row]))


@pytest.mark.parametrize("pursuer", [covey.CommittedPursuer(), covey.FixedSequence([2, 0, 1])])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_team_that_steers_at_random(pursuer, seed):
    shares = np.random.default_rng(seed).uniform(-1.0, 1.0, (400, 3))
    rows = iter(shares * (RATE * DT))
    record = covey.simulate(
        *game_of(seed),
        evaders=lambda situation: next(rows)[list(situation.evaders)],
        pursuer=pursuer,
        **SEEN,
    )
    env = pursuit_v0.TeamEnv(pursuer=pursuer, **GAME)
    env.reset(seed=seed, options=options_of(seed))
    assert_same(record, captures_of_one_side(env, lambda row: shares[row]))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_whole_game_of_two_strategies_flown_by_agents(seed):
    """Plans that are turned into turn rates are flown exactly, also where a turn ends in a step."""
    record = covey.simulate(*game_of(seed), evaders=TEAM, **SEEN)
    shares = np.clip(record.evader_turns / (RATE * DT), -1.0, 1.0)
    flown = directions_of(record)
    env = pursuit_v0.parallel_env(**GAME)
    env.reset(seed=seed, options=options_of(seed))
    captures, row = [], 0
    while env.agents:
        actions = {f"evader_{i}": shares[row, [i]] for i in range(3)} | {"pursuer_0": flown[row]}
        _, _, out, _, infos = env.step({agent: actions[agent] for agent in env.agents})
        time, row = infos["pursuer_0"]["time"], row + 1
        captures += [(i, time) for i in range(3) if out.get(f"evader_{i}")]
    assert_same(record, captures)


@pytest.mark.parametrize("strategy", TEAMS, ids=lambda team: type(team).__name__)
@pytest.mark.parametrize("pursuer", [covey.FlyingPursuer(), covey.NearestFirst()])
@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_two_strategies_and_a_pursuer_that_has_a_place(sensing, pursuer, strategy):
    record = covey.simulate(
        *game_of(1),
        evaders=strategy,
        pursuer=InTheMiddle(pursuer),
        seed=7,
        **(SEEN | {"sensing": sensing}),
    )
    assert_same(record, captures_of_strategies(sensing, REACH, 1, strategy, pursuer))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_hidden_pursuer_with_hardly_any_reach_is_the_disk_of_the_simulation(seed):
    """All that a disk can do beyond a real pursuer is to be anywhere within ρ after a capture."""
    reach, strategy = 1e-12, covey.OpenLoop(starts=4)
    pursuer = covey.FixedSequence([1, 2, 0])
    record = covey.simulate(
        *game_of(seed, reach=reach),
        evaders=strategy,
        pursuer=pursuer,
        seed=7,
        **(SEEN | {"sensing": "hidden"}),
    )
    assert_same(record, captures_of_strategies("hidden", reach, seed, strategy, pursuer))
