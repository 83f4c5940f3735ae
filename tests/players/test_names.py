"""A strategy's name stands for the strategy with its defaults, wherever one is taken."""

from __future__ import annotations

import dataclasses
from functools import partial

import numpy as np
import pytest

import covey
from covey.envs.single import PursuerEnv, TeamEnv
from covey.envs.vector import PursuerVectorEnv, TeamVectorEnv
from covey.players.names import PURSUERS, TEAMS

TEAM = covey.Team([(0.3, 0.1), (-0.2, 0.4)], [0.3, 2.0])
DISK = covey.PursuerDisk()


@pytest.mark.parametrize("known", [TEAMS, PURSUERS])
def test_a_name_is_that_by_which_the_strategy_describes_itself(known):
    assert [make().describe()["name"] for make in known.values()] == list(known)


def test_a_game_of_names_is_the_game_of_the_strategies():
    by_name = covey.simulate(
        TEAM, DISK, evaders="straight-away", pursuer="nearest-first", update_time=0.1
    )
    strategies = {"evaders": covey.StraightAway(), "pursuer": covey.NearestFirst()}
    game = covey.simulate(TEAM, DISK, **strategies, update_time=0.1)
    assert by_name.strategies == game.strategies
    assert by_name.capture_times.tolist() == game.capture_times.tolist()


def test_the_worst_case_of_a_name_is_that_of_the_strategy():
    by_name = covey.worst_case(TEAM, DISK, evaders="open-loop", update_time=0.1)
    assert by_name == covey.worst_case(TEAM, DISK, evaders=covey.OpenLoop(), update_time=0.1)


def test_a_scenario_takes_names_too():
    scenario = covey.load_scenario("fig3")
    once = dataclasses.replace(scenario, evaders="open-loop", pursuer="nearest-first")
    assert once.simulate().strategies["evaders"] == covey.OpenLoop().describe()
    assert once.plan().starts == covey.OpenLoop().starts


@pytest.mark.parametrize("side", ["evaders", "pursuer"])
def test_an_unknown_name_is_told_with_those_that_exist(side):
    names = TEAMS if side == "evaders" else PURSUERS
    message = f"^{side}: expected one of {', '.join(names)}, got 'comitted'$"
    with pytest.raises(covey.InputError, match=message):
        covey.simulate(TEAM, DISK, **{side: "comitted"})


@pytest.mark.parametrize(
    ("make", "side", "name", "strategy"),
    [
        (PursuerEnv, "evaders", "open-loop", covey.OpenLoop()),
        (TeamEnv, "pursuer", "nearest-first", covey.NearestFirst()),
        (partial(PursuerVectorEnv, 2), "evaders", "open-loop", covey.OpenLoop()),
        (partial(TeamVectorEnv, 2), "pursuer", "best-sequence", covey.BestSequence()),
    ],
)
def test_an_environment_plays_against_a_name_as_against_its_strategy(make, side, name, strategy):
    seen = []
    for opponent in (name, strategy):
        env = make(**{side: opponent}, team_size=2, time_limit=1.0)
        env.reset(seed=0)
        env.action_space.seed(0)
        seen.append(env.step(env.action_space.sample())[0])
    assert np.array_equal(*seen)


def test_batches_are_played_by_strategies_that_are_compiled_also_by_name():
    with pytest.raises(covey.InputError, match=r"plays compiled, got NearestFirst\(\)"):
        TeamVectorEnv(2, pursuer="nearest-first")
