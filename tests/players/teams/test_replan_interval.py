"""A team plans again at its own pace, and after every capture."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import covey
from covey.players.teams.replan_interval import at_interval
from random_games import random_game

REPLANNING = [
    covey.IterativeOpenLoop(starts=2, restarts=1, replan_time=0.2),
    covey.ConstantHeading(starts=2, restarts=1, replan_time=0.2),
    covey.StraightAway(replan_time=0.2),
    covey.KnownSequence(replan_time=0.2),
    covey.LargestDistance(replan_time=0.2),
    covey.SmallestDanger(replan_time=0.2),
]


def test_at_its_pace_and_at_captures():
    """0.3 is no sum of update times in binary; evader 0 is captured at 0.4."""
    team = covey.Team([(0.3, 0.0), (0.0, 1.0)], [0.0, math.pi / 2], turn_rates=0.0)
    asked = []

    def plan(situation):
        asked.append(situation.time)
        return situation.turns

    evaders, pursuer = at_interval(plan, 0.3), covey.FixedSequence([0, 1])
    covey.simulate(
        team, covey.PursuerDisk(), evaders=evaders, pursuer=pursuer, update_time=0.1, time_limit=1.2
    )
    assert asked == pytest.approx([0.0, 0.3, 0.4, 0.7, 1.0])


@pytest.mark.parametrize("evaders", REPLANNING, ids=lambda evaders: type(evaders).__name__)
def test_between_plans_it_keeps_to_the_last_one(evaders):
    team, disk = random_game(np.random.default_rng(4), 4)
    game = covey.simulate(team, disk, evaders=evaders, update_time=0.05, seed=3, time_limit=1.5)
    goals = game.evader_headings + game.evader_turns
    changed = np.abs(np.diff(goals, axis=0)).max(axis=1) > 1e-6
    times = game.times[1:][changed]
    wait = np.diff([0.0, *times])
    at_capture = np.isin(times, game.capture_times)
    assert (wait[~at_capture] >= 0.2 - 1e-6).all()


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("replan_time", [0.0, 0.03, 0.2, 1e9])
def test_compiled_and_python_games_plan_at_the_same_times(sensing, replan_time):
    evaders = covey.IterativeOpenLoop(starts=2, restarts=1, replan_time=replan_time)
    for seed in range(4):
        team, disk = random_game(np.random.default_rng(seed), 2 + seed, radius=0.1)
        compiled, python = (
            covey.simulate(team, disk, evaders=each, sensing=sensing, update_time=0.05, seed=seed)
            for each in (evaders, evaders.start(seed))
        )
        for field in dataclasses.fields(covey.Game):
            if field.type == "Floats":
                ours, theirs = getattr(compiled, field.name), getattr(python, field.name)
                assert np.array_equal(ours, theirs), field.name


@pytest.mark.parametrize("evaders", REPLANNING, ids=lambda evaders: type(evaders).__name__)
@pytest.mark.parametrize("bad", [-0.1, math.nan, math.inf, "1"])
def test_what_is_no_time_is_refused(evaders, bad):
    with pytest.raises(covey.InputError, match="replan_time: expected"):
        dataclasses.replace(evaders, replan_time=bad)
