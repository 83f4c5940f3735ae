"""The upper end that knows turn limits, against teams that fly what they like."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from covey.bounds.polygon_bound import (
    DENSE,
    SPARSE,
    Opening,
    bound_near,
    opening_towards,
    turn_limits_known,
)
from covey.bounds.upper_end import earliest_end
from covey.planning.border import about_center
from flights import ConstantBearing, fly
from frames import ELSEWHERE
from random_games import games, random_game, time_rounding

UPDATES = 60


def bounded(team, disk, sequence, share):
    """The team's best answer to a sequence, the pursuer's opening, and the proven bound."""
    point = covey.PursuerDisk(disk.center, 0.0, disk.speed)
    plan = covey.plan_for_sequence(team, point, sequence)
    opening = opening_towards(team, point, plan, share * plan.capture_times[0])
    start = covey.PursuerDisk(disk.center, 0.0, disk.speed, disk.capture_radius)
    bound, _ = bound_near(team, start, plan.sequence, plan.goal_headings, DENSE, opening)
    return plan, opening, bound


def survived(team, disk, plan, opening, turning):
    """How long a team lives that turns as `turning` says, against the pursuer of the bound."""
    pursuer = ConstantBearing(opening.end, disk.speed, plan.sequence, disk.capture_radius)
    positions, headings, time = team.positions, team.headings, 0.0
    update = plan.survival_time / UPDATES
    while pursuer.left:
        duration = opening.time if time == 0.0 and opening.time > 0.0 else update
        now = covey.Team(positions, headings, team.speeds, team.turn_rates)
        most = np.minimum(team.turn_rates * duration, math.pi)
        turns = np.clip(turning(now, pursuer), -most, most)
        before = positions
        positions, headings = fly(positions, headings, team, turns, duration)
        if time >= opening.time:
            pursuer.follow(before, positions, duration)
        time += duration
    return opening.time + pursuer.time


def answer(team, pursuer):
    """The best answer to the rest of the sequence, from here."""
    left = pursuer.left
    disk = covey.PursuerDisk(pursuer.place, 0.0, pursuer.speed)
    order = np.argsort(np.argsort(left))
    alive = np.sort(left)
    turns = np.zeros(len(team))
    turns[alive] = covey.plan_for_sequence(team.take(alive), disk, order).turns
    return turns


def as_planned(plan):
    """The best answer to the whole sequence, from the beginning."""
    return lambda now, pursuer: covey.turns_to(now, plan.goal_headings)


@pytest.mark.parametrize("share", [0.0, 0.8])
@pytest.mark.parametrize("seed", range(4))
def test_no_team_outlives_it(seed, share):
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 1 + seed % 3, capture_radius=0.02 * (seed % 2))
    plan, opening, bound = bounded(team, disk, generator.permutation(len(team)), share)

    def roam(now, _):
        return generator.uniform(-math.pi, math.pi, len(now))

    def waver(now, pursuer):
        return answer(now, pursuer) + generator.choice([-0.5, 0.0, 0.5], len(now))

    for turning in (answer, as_planned(plan), waver, roam):
        assert survived(team, disk, plan, opening, turning) <= bound * (1.0 + 1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_nobody_is_the_target_before_its_turn_limit_is_dropped(seed):
    """Not even in a team that flies towards the pursuer's way, to be captured soon."""
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3)
    team = covey.Team(team.positions, team.headings, generator.uniform(0.1, 0.8, 3), 1e4)
    sequence = tuple(generator.permutation(3).tolist())
    opening = Opening(0.0, disk.center)
    known = turn_limits_known(team, disk, sequence, opening)
    pursuer, positions = ConstantBearing(opening.end, 1.0, sequence), team.positions
    while pursuer.left:
        target = pursuer.left[0]
        goals = np.where(np.arange(3)[:, np.newaxis] == target, pursuer.place, positions[target])
        off = goals - positions
        length = np.hypot(*off.T)[:, np.newaxis]
        step = np.minimum(team.speeds[:, np.newaxis] * 1e-3, length)
        after = positions + step * off / np.maximum(length, 1e-300)
        pursuer.follow(positions, after, 1e-3)
        positions = after
    targets = dict(zip(sequence, [0.0, *pursuer.captures], strict=False))
    assert all(known[i] <= time + 1e-9 for i, time in targets.items())
    assert known[sequence[-1]] >= 0.6 * targets[sequence[-1]]


@pytest.mark.parametrize("seed", range(4))
def test_a_team_far_away_nearly_attains_it(seed):
    """All have turned before the first capture, and an opening costs little."""
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3)
    team = covey.Team(disk.center + 20.0 * (team.positions - disk.center), team.headings)
    plan, opening, bound = bounded(team, disk, generator.permutation(3), 0.2)
    lived = survived(team, disk, plan, opening, as_planned(plan))
    assert 0.99 * bound <= lived <= bound * (1.0 + 1e-9)
    assert 0.995 * bound <= plan.survival_time <= bound * (1.0 + 1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_no_team_of_mixed_vehicles_outlives_it(seed):
    """Some stand, can't turn, or turn at once."""
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3, mixed=True)
    plan, opening, bound = bounded(team, disk, generator.permutation(3), 0.5)
    assert survived(team, disk, plan, opening, answer) <= bound * (1.0 + 1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_without_an_opening_no_turn_limit_gives_the_bound_of_simple_motion(seed):
    team, disk = random_game(np.random.default_rng(seed), 3)
    agile = covey.Team(team.positions, team.headings, team.speeds, math.inf)
    fast = covey.Team(team.positions, team.headings, team.speeds, 1e9)
    plan = covey.plan_for_sequence(agile, disk, [0, 1, 2])
    headings = plan.goal_headings
    opening = opening_towards(agile, disk, plan, 0.0)
    free = bound_near(agile, disk, plan.sequence, headings, DENSE, opening)[0]
    limited = bound_near(fast, disk, plan.sequence, headings, DENSE, opening)[0]
    assert limited == pytest.approx(free, rel=1e-7)
    assert free == pytest.approx(plan.survival_time, rel=1e-9)


@settings(max_examples=20)
@given(games(most=3, fastest=0.7), st.sampled_from([0.0, 0.3, 0.8]))
def test_is_at_least_the_best_answer_whatever_the_unit(game, share):
    team, disk, _ = game
    team, disk = about_center(team, covey.PursuerDisk(disk.center, 0.0, disk.speed))
    plan, opening, bound = bounded(team, disk, range(len(team)), share)
    sparse, _ = bound_near(team, disk, plan.sequence, plan.goal_headings, SPARSE, opening)
    least = plan.survival_time - time_rounding(team, disk, plan.survival_time)
    assert least * (1.0 - 1e-9) <= min(bound, sparse)


@pytest.mark.parametrize("seed", range(4))
def test_more_turning_never_lowers_an_end_and_frames_do_not_matter(seed):
    team, disk = random_game(np.random.default_rng(seed), 1 + seed)
    limited, free = earliest_end(team, disk), earliest_end(team, disk, openings=())
    assert limited.time <= free.time
    assert limited.needs_limits == (limited.time < free.time)
    there = earliest_end(*ELSEWHERE.game(team, disk))
    assert there.time == pytest.approx(ELSEWHERE.time * limited.time, rel=1e-7)


def test_one_evader_that_cannot_turn_by_hand():
    """It flies towards the pursuer, and is met half way."""
    team = covey.Team([[1.0, 0.0]], [math.pi], 0.25, 0.0)
    end = earliest_end(team, covey.PursuerDisk())
    found = covey.bracket(team, covey.PursuerDisk())
    assert found.upper_by.name == "TURN_LIMITS"
    assert 0.8 <= end.time <= 0.95
    assert found.upper == end.time
