"""Plans for teams beyond a table of all sets: what they claim is guaranteed."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.kernels.maximum.problem import Iterate, Problem
from covey.kernels.maximum.working_set import new_working_set
from covey.planning.compiled_objective import compiled_objective
from covey.planning.confirm import confirmed
from covey.planning.guarantee import about_center, pursuit_of, worst_sequence
from covey.planning.multistart import Search
from random_games import random_game


@pytest.mark.parametrize("count", [19, 24, 50])
def test_a_plan_within_a_second_is_worth_what_it_says(count):
    team, disk = random_game(np.random.default_rng(count), count)
    plan = covey.plan(team, disk, starts=1, time_limit=1.0)
    found = covey.guaranteed_survival(team, disk, plan.turns, time_limit=2.0)
    assert 0.0 < plan.survival_time <= found.upper * (1.0 + 1e-12)


def test_a_sequence_that_refutes_a_plan_makes_it_ascend_again():
    team, disk = about_center(*random_game(np.random.default_rng(0), 6))
    problem = Problem(team.as_rows(), pursuit_of(disk), compiled_objective(covey.LastCapture(), 6))
    search = Search(problem, 1e-9, np.empty((0, 6)), math.inf)
    best = search.refine(Iterate(np.full(6, 0.5), new_working_set(6)))
    best.iterate.working_set.used[0] = 1
    claimed = best._replace(value=1.1 * best.value)

    def guarantee_of(turns):
        return worst_sequence(team, disk, turns, total=False)

    before = guarantee_of(best.iterate.turns).time
    proven, guarantee = confirmed(search, claimed, guarantee_of, math.inf)
    assert proven.value == pytest.approx(guarantee.upper, rel=1e-9)
    assert guarantee == guarantee_of(proven.iterate.turns)
    assert guarantee.time >= before
    assert proven.steps >= claimed.steps
    assert proven.starts == claimed.starts


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
