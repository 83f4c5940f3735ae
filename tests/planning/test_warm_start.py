"""A plan is never worse than the one it started from, and the old plan is a start."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from kernels import reference_game
from random_games import games, random_game, random_turns

_extreme_turns = st.sampled_from([-math.pi, -math.pi / 2, 0.0, math.pi / 2, math.pi])


@given(games(most=5), st.integers(1, 3), st.integers(0, 3))
@settings(max_examples=300)
def test_never_worse_than_the_start(game, starts, seed):
    team, disk, turns = game
    plan = covey.plan(team, disk, warm_start=turns, starts=starts, seed=seed)
    assert plan.survival_time >= covey.guaranteed_survival(team, disk, turns).time
    again = covey.plan(team, disk, warm_start=plan, starts=starts, seed=seed + 1)
    assert again.survival_time >= plan.survival_time


@given(st.lists(_extreme_turns, min_size=4, max_size=4), st.integers(0, 100))
def test_never_worse_than_the_most_extreme_turns(turns, seed):
    team, disk = random_game(np.random.default_rng(seed), 4)
    plan = covey.plan(team, disk, warm_start=turns, starts=1)
    assert plan.starts == 1
    assert plan.survival_time >= covey.guaranteed_survival(team, disk, turns).time


@pytest.mark.parametrize("reach", [0.02, 0.1])
def test_never_worse_with_a_capture_radius(reach):
    """Where a detour can be the shorter way, which a bound must not forget."""
    generator = np.random.default_rng(round(100 * reach))
    for _ in range(100):
        count = int(generator.integers(2, 6))
        team, disk = random_game(generator, count, capture_radius=reach)
        turns = random_turns(generator, count)
        plan = covey.plan(team, disk, warm_start=turns, starts=3)
        assert plan.survival_time >= covey.guaranteed_survival(team, disk, turns).time
        again = covey.plan(team, disk, warm_start=plan, starts=3, seed=1)
        assert again.survival_time >= plan.survival_time


def test_one_that_cannot_turn_takes_no_turn_from_it():
    team, disk = random_game(np.random.default_rng(0), 2)
    team = covey.Team(team.positions, team.headings, team.speeds, [0.0, math.pi / 2])
    plan = covey.plan(team, disk, warm_start=[1.0, 1.0], starts=1)
    assert plan.turns[0] == 0.0
    assert plan.goal_headings[0] == pytest.approx(team.headings[0])
    assert covey.plan(team, disk, warm_start=plan, starts=1).turns[0] == 0.0


@pytest.mark.parametrize("count", [1, 3, 5])
def test_a_plan_that_starts_from_itself_stays(count):
    generator = np.random.default_rng(count)
    team, disk = random_game(generator, count)
    plan = covey.plan(team, disk)
    again = covey.plan(team, disk, warm_start=plan, starts=1)
    assert again.survival_time == pytest.approx(plan.survival_time, rel=1e-9, abs=0.0)
    assert again.steps <= 2
    from_turns = covey.plan(team, disk, warm_start=plan.turns.tolist(), starts=1)
    assert from_turns.turns.tolist() == again.turns.tolist()


@pytest.mark.parametrize("seed", range(10))
def test_the_rest_of_a_plan_is_worth_what_is_left_of_it(seed):
    """After Δt of a plan against a hidden pursuer the guarantee is what it was, less Δt."""
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 4)
    plan = covey.plan(team, disk, starts=4)
    first = min(
        covey.capture_times(team, disk, plan.turns, [i, *(j for j in range(4) if j != i)])[0]
        for i in range(4)
    )
    elapsed = 0.5 * first
    left = np.sign(plan.turns) * np.maximum(np.abs(plan.turns) - elapsed * team.turn_rates, 0.0)
    later = covey.Team(
        [reference_game.place(team, plan.turns, i, elapsed) for i in range(4)],
        team.headings + plan.turns - left,
    )
    grown = covey.PursuerDisk(disk.center, elapsed)
    rest = covey.guaranteed_survival(later, grown, left).time
    assert rest == pytest.approx(plan.survival_time - elapsed, rel=1e-12, abs=0.0)
    again = covey.plan(later, grown, warm_start=left, starts=1)
    assert again.survival_time >= rest
