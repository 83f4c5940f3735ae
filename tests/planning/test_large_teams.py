"""Plans for teams beyond a table of all sets: what they claim is guaranteed."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.kernels.arrays import new_workspace
from covey.kernels.maximum.problem import Problem
from covey.planning import workspace as workspaces
from covey.planning.border import about_center, pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.multistart import NONE, Search
from covey.planning.open_loop import guess_uniforms
from random_games import random_game, random_turns


@pytest.mark.parametrize("count", [19, 24, 50])
def test_a_plan_within_a_second_is_worth_what_it_says(count):
    team, disk = random_game(np.random.default_rng(count), count)
    plan = covey.plan(team, disk, starts=1, time_limit=1.0)
    found = covey.guaranteed_survival(team, disk, plan.turns, time_limit=2.0)
    assert 0.0 < plan.survival_time <= found.upper * (1.0 + 1e-12)


@pytest.mark.parametrize("name", ["circle", "line", "clusters", "pairs", "one-fast", "mixed"])
def test_degenerate_teams_of_thirty_have_plans_worth_what_they_say(name):
    game = covey.load_instance(f"{name}-30")
    plan = covey.plan(game.team, game.disk, starts=1, time_limit=0.5)
    found = covey.guaranteed_survival(game.team, game.disk, plan.turns, time_limit=0.3)
    assert 0.0 < plan.survival_time <= found.upper * (1.0 + 1e-12)


@pytest.mark.parametrize("starts", [1, 6])
@pytest.mark.parametrize("count", [19, 24, 50])
def test_a_plan_without_any_time_is_worth_what_it_says(count, starts):
    team, disk = random_game(np.random.default_rng(count), count)
    plan = covey.plan(team, disk, starts=starts, time_limit=0.0)
    found = covey.guaranteed_survival(team, disk, plan.turns, time_limit=0.3)
    assert 0.0 < plan.survival_time <= found.upper * (1.0 + 1e-12)
    again = covey.plan(team, disk, warm_start=plan, time_limit=0.0)
    assert again.survival_time >= plan.survival_time * (1.0 - 1e-12)


@pytest.mark.parametrize("largest_table", [3, 20])
@pytest.mark.parametrize("count", [6, 12])
def test_a_plan_of_a_large_team_is_worth_what_a_table_says(without_tables, count, largest_table):
    team, disk = random_game(np.random.default_rng(count), count)
    without_tables(largest_table)
    found = covey.plan(team, disk, starts=4)
    workspaces.new_workspace = new_workspace
    workspaces._kept.__dict__.clear()
    worst = covey.guaranteed_survival(team, disk, found.turns)
    assert found.survival_time == pytest.approx(worst.time, rel=1e-12)
    assert found.survival_time > 0.9 * covey.plan(team, disk, starts=4).survival_time


def test_a_maximum_by_tables_is_a_maximum_without(without_tables):
    team, disk = random_game(np.random.default_rng(4), 12)
    expected = covey.plan(team, disk, starts=4)
    without_tables()
    found = covey.plan(team, disk, starts=1, warm_start=expected)
    assert found.survival_time == pytest.approx(expected.survival_time, rel=1e-9)


def test_a_warm_start_of_a_large_team_never_guarantees_less(without_tables):
    generator = np.random.default_rng(5)
    without_tables()
    for _ in range(10):
        team, disk = random_game(generator, 7)
        turns = random_turns(generator, 7)
        before = covey.guaranteed_survival(team, disk, turns).time
        after = covey.plan(team, disk, starts=1, warm_start=turns).survival_time
        assert after >= before * (1.0 - 1e-12)


def test_a_refined_plan_guarantees_what_it_says_and_no_less(without_tables):
    generator = np.random.default_rng(7)
    refined = []
    without_tables()
    for _ in range(10):
        team, disk = about_center(*random_game(generator, 7))
        objective = compiled_objective(covey.LastCapture(), 7)
        problem = Problem(team.as_rows(), pursuit_of(disk), objective)
        search = Search(problem, 1e-9, guess_uniforms(0, 4, 7), math.inf)
        best = search.run(NONE, 4)
        exact = search.refine(best.iterate, best.value)
        assert exact.value >= best.value
        refined.append((team, disk, exact))
    workspaces.new_workspace = new_workspace
    workspaces._kept.__dict__.clear()
    for team, disk, exact in refined:
        worst = covey.guaranteed_survival(team, disk, exact.iterate.turns)
        assert exact.value == pytest.approx(worst.time, rel=1e-12)


def test_a_game_of_eighteen_lasts_as_long_as_the_first_plan_promises():
    team, disk = random_game(np.random.default_rng(6), 18)
    strategy = covey.IterativeOpenLoop(starts=1, restarts=0, replan_time=0.2)
    game = covey.simulate(team, disk, evaders=strategy, update_time=0.1)
    promised = covey.plan(team, disk, starts=1).survival_time
    assert game.survival_time >= promised * (1.0 - 1e-9)


def test_a_guarantee_says_whether_it_is_exact():
    exact = covey.guaranteed_survival(*random_game(np.random.default_rng(1), 5), np.zeros(5))
    assert exact.exact
    assert exact.upper == exact.time
    team, disk = random_game(np.random.default_rng(2), 50)
    early = covey.guaranteed_survival(team, disk, np.zeros(50), time_limit=0.0)
    assert not early.exact
    assert 0.0 < early.time < early.upper
    attained = covey.capture_times(team, disk, np.zeros(50), early.sequence)[-1]
    assert attained == pytest.approx(early.upper, rel=1e-12)


def test_a_time_limit_of_a_guarantee_is_checked():
    team, disk = random_game(np.random.default_rng(3), 3)
    with pytest.raises(covey.InputError, match=r"^time_limit: expected .*, got -1"):
        covey.guaranteed_survival(team, disk, np.zeros(3), time_limit=-1)
