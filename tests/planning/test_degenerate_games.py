"""Games that are special solve as well as any other: as good a plan, found as surely and as soon.

They are named in `planning.degenerate`.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from scipy.optimize import differential_evolution

import covey
from kernels import kernel_calls
from planning.continued_ascents import ascent, assert_cannot_be_continued
from planning.degenerate_games import BEST_KNOWN, GAMES
from random_games import random_game, random_turns

MISSED_BY_SMALL_TEAMS, MISSED = 1e-6, 1e-3
"""Of the survival time, relative: by how much a default plan may miss the best one known."""
DEARER_AT_MOST = 5.0
"""A plan's interceptions over the mean of ordinary games."""

# Starts from which an ascent once ended below what it comes to if it goes on.
ENDED_EARLY = (
    ("two on one spot", [0.623, 2.42]),
    ("two pairs", [0.261, 1.924, -2.939, 2.595]),
    ("a mirrored pair", [-0.882, -2.306]),
    ("a mirrored pair and one on the axis that comes", [-1.458, -2.151, 2.727]),
    ("two of four in the disk", [0.757, 0.374, -1.971, -0.026]),
    ("all three on the border", [1.423, 3.033, -0.837]),
    ("4 at the corners of a polygon, inward", [0.513, -2.382, -2.183, 0.241]),
    ("three that fly at the pursuer from three sides", [-0.566, -0.119, -0.051]),
    ("three, one of them caught while it turns", [0.0, -2.205, 2.311]),
)

names = pytest.mark.parametrize("name", GAMES)


@cache
def planned(name):
    return covey.plan(*GAMES[name])


def evolved(team, disk):
    """The best that differential evolution finds, which knows neither gradients nor sequences."""
    answer = differential_evolution(
        lambda turns: -kernel_calls.least(team, disk, turns)[0],
        [(-math.pi, math.pi)] * len(team),
        seed=1,
        tol=1e-10,
        maxiter=150,
        polish=False,
    )
    return -answer.fun


@cache
def ordinary_interceptions(count):
    generator = np.random.default_rng(count)
    plans = [covey.plan(*random_game(generator, count)) for _ in range(10 if count < 6 else 4)]
    return float(np.mean([plan.interceptions for plan in plans]))


@pytest.mark.parametrize("name", [name for name in GAMES if name not in BEST_KNOWN])
def test_evolution_finds_nothing_better(name):
    best = evolved(*GAMES[name])
    assert planned(name).survival_time >= best * (1.0 - MISSED_BY_SMALL_TEAMS)


@pytest.mark.parametrize("name", BEST_KNOWN)
def test_the_plan_is_the_best_one_known(name):
    assert planned(name).survival_time >= BEST_KNOWN[name] * (1.0 - MISSED)


@names
def test_the_search_converges(name):
    assert planned(name).status is covey.PlanStatus.CONVERGED


@names
def test_the_plan_is_worth_what_it_says(name):
    team, disk = GAMES[name]
    plan = planned(name)
    assert plan.survival_time == covey.guaranteed_survival(team, disk, plan.turns).time
    assert sum(plan.weights) == pytest.approx(1.0, abs=1e-9)


@names
def test_the_plan_costs_no_more_than_others(name):
    plan = planned(name)
    assert plan.interceptions <= DEARER_AT_MOST * ordinary_interceptions(len(plan.turns))


@names
def test_an_ascent_from_anywhere_converges_where_it_cannot_be_continued(name):
    team, disk = GAMES[name]
    generator = np.random.default_rng(5)
    for _ in range(20):
        ends = generator.choice([0.0, math.pi, -math.pi], len(team))
        start = np.where(
            generator.random(len(team)) < 0.15, ends, random_turns(generator, len(team))
        )
        plan = ascent(team, disk, start)
        assert plan.status is covey.PlanStatus.CONVERGED
        assert_cannot_be_continued(team, disk, plan)


@pytest.mark.parametrize(("name", "start"), ENDED_EARLY)
def test_an_ascent_converges_from_where_it_once_ended_early(name, start):
    team, disk = GAMES[name]
    plan = ascent(team, disk, start)
    assert plan.status is covey.PlanStatus.CONVERGED
    assert_cannot_be_continued(team, disk, plan)


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
@names
def test_a_game_lasts_as_long_as_its_plan_guaranteed(name, sensing):
    team, disk = GAMES[name]
    game = covey.simulate(team, disk, sensing=sensing, update_time=0.1)
    assert game.survival_time >= game.guarantee * (1.0 - 1e-9)


def test_corners_of_a_polygon_may_swap_their_turns():
    """No evader is special: the same plan one corner on is worth the same."""
    team, disk = GAMES["3 at the corners of a polygon, away"]
    time = planned("3 at the corners of a polygon, away").survival_time
    turns = np.array(planned("3 at the corners of a polygon, away").turns)
    for k in range(3):
        rolled = covey.guaranteed_survival(team, disk, np.roll(turns, k)).time
        assert rolled == pytest.approx(time, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("name", ["all where the pursuer is", "all within reach"])
def test_there_is_nothing_to_gain_for_a_team_that_is_caught_at_once(name):
    assert planned(name).survival_time == 0.0
