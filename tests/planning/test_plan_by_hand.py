"""Plans whose value is known on paper, and teams that are special in some way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import covey
from covey.model.angles import away_from
from kernels import reference_game
from random_games import random_game, random_turns

SOLVED = 1e-8
"""Of the survival time, relative: a plan ends where a step promises less than 1e-9."""


def assert_valid(plan, team, disk):
    """Whatever the search did, the plan is one, and its value is exact."""
    assert (np.abs(plan.turns) <= math.pi).all()
    guarantee = covey.guaranteed_survival(team, disk, plan.turns)
    assert plan.survival_time == guarantee.time
    ends = [covey.capture_times(team, disk, plan.turns, s)[-1] for s in plan.critical_sequences]
    assert guarantee.sequence in plan.critical_sequences
    assert ends == sorted(ends)
    assert ends[0] == guarantee.time
    assert ends[-1] <= guarantee.time * (1.0 + 1e-6)
    off = plan.goal_headings - team.headings - plan.turns
    assert np.sin(0.5 * off) == pytest.approx(0.0, abs=1e-14)
    assert (np.abs(plan.goal_headings) <= math.pi).all()


@pytest.mark.parametrize("speed", [0.05, 0.25, 0.9])
@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.3, 0.0), (0.2, 0.1)])
@pytest.mark.parametrize("heading", [0.7, -2.0, 0.7 + math.pi])
def test_one_agile_evader_flees_straight_away(frame, speed, radius, reach, heading):
    bearing = 0.7
    team, disk = frame.game(
        covey.Team([(2 * math.cos(bearing), 2 * math.sin(bearing))], [heading], speed, math.inf),
        covey.PursuerDisk((0.0, 0.0), radius, 1.0, reach),
    )
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    assert plan.status is covey.PlanStatus.CONVERGED
    wanted = frame.time * (2.0 - radius - reach) / (1.0 - speed)
    assert plan.survival_time == pytest.approx(wanted, rel=SOLVED, abs=0.0)
    assert math.cos(plan.goal_headings[0] - frame.angle - bearing) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("seed", range(20))
def test_one_evader_turns_until_it_flies_straight_away_from_where_the_disk_is(seed):
    """With a limited turn rate: along the line through the disk's centre and the end of the turn.

    Of the two sides the better one; where capture comes first, whatever the end would have been.
    """
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 1, radius=0.1 * (seed % 2))
    best = 0.0
    for side in (1.0, -1.0):

        def swerve(size, side=side):
            turns = [side * size]
            end = (
                reference_game.place(team, turns, 0, reference_game.turn_end(team, turns, 0))
                - disk.center
            )
            return math.sin(team.headings[0] + turns[0] - math.atan2(end[1], end[0]))

        grid = np.linspace(0.0, math.pi, 400)
        signs = np.sign([swerve(size) for size in grid])
        sizes = [
            brentq(swerve, a, b)
            for a, b, s, t in zip(grid, grid[1:], signs, signs[1:], strict=False)
            if s != t
        ]
        for size in [*sizes, 0.0, math.pi]:
            value = reference_game.sequence_times(team, disk, [side * size], [0])[0]
            best = max(best, value)
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    assert plan.survival_time == pytest.approx(best, rel=SOLVED, abs=0.0)


def test_two_in_line_flee_one_after_the_other(frame):
    """Both straight ahead of the pursuer, in simple motion: the rear one first, then the other."""
    team, disk = frame.game(
        covey.Team([(1.0, 0.0), (2.0, 0.0)], [0.0, 0.0], 0.25, math.inf), covey.PursuerDisk()
    )
    guarantee = covey.guaranteed_survival(team, disk, [0.0, 0.0])
    assert guarantee.time == pytest.approx(frame.time * 2.0 / 0.75, rel=1e-14, abs=0.0)
    assert guarantee.sequence == (0, 1)
    assert covey.plan(team, disk).survival_time > guarantee.time * (1.0 + SOLVED)


def test_two_on_either_side_flee_apart(frame):
    """Whichever is captured first, at T = d / (v_p - v), was best off flying away from both.

    For either order the headings straight away are the best there are, and then the gap is 2 v_p T.
    """
    team = covey.Team([(1.0, 0.0), (-1.0, 0.0)], [2.0, 0.3], 0.25, math.inf)
    plan = covey.plan(*frame.game(team, covey.PursuerDisk()))
    first = 1.0 / 0.75
    wanted = frame.time * (first + 2.0 * first / 0.75)
    assert plan.survival_time == pytest.approx(wanted, rel=SOLVED, abs=0.0)


def test_a_team_that_stands_is_visited_by_the_shortest_way():
    team = covey.Team([(1.0, 0.0), (-2.0, 0.0), (3.0, 0.0)], [0.1, 0.2, 0.3], 0.0)
    plan = covey.plan(team, covey.PursuerDisk(speed=2.0))
    assert_valid(plan, team, covey.PursuerDisk(speed=2.0))
    assert plan.survival_time == 3.5
    assert plan.status is covey.PlanStatus.CONVERGED


def test_a_team_that_cannot_turn_has_no_choice():
    generator = np.random.default_rng(8)
    team, disk = random_game(generator, 4)
    straight = covey.Team(team.positions, team.headings, team.speeds, 0.0)
    plan = covey.plan(straight, disk)
    assert_valid(plan, straight, disk)
    wanted = covey.guaranteed_survival(straight, disk, np.zeros(4)).time
    assert plan.survival_time == pytest.approx(wanted, rel=1e-14, abs=0.0)
    assert plan.status is covey.PlanStatus.CONVERGED
    assert np.cos(plan.goal_headings - team.headings) == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("seed", range(6))
def test_one_that_cannot_turn_does_not_keep_the_others_from_their_best(seed):
    """It flies as one does that could turn and happens to need not; the others plan around it."""
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3)
    rates = np.array([0.0, math.pi / 2, math.pi / 2])
    plan = covey.plan(covey.Team(team.positions, team.headings, 0.25, rates), disk)
    assert plan.status is covey.PlanStatus.CONVERGED
    rates[0] = 1e-12
    almost = covey.plan(covey.Team(team.positions, team.headings, 0.25, rates), disk)
    assert plan.survival_time == pytest.approx(almost.survival_time, rel=SOLVED, abs=0.0)


def test_mirrored_team():
    """What is good for one half is good for the other, and the planner finds as much from both."""
    places = [(0.4, 0.3), (0.4, -0.3), (-0.2, 0.5), (-0.2, -0.5)]
    team = covey.Team(places, [0.3, -0.3, 2.0, -2.0])
    disk = covey.PursuerDisk()
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    mirrored = -plan.turns[[1, 0, 3, 2]]
    assert covey.guaranteed_survival(team, disk, mirrored).time == plan.survival_time
    assert len(plan.critical_sequences) >= 2


@pytest.mark.parametrize("count", [2, 3, 4])
def test_coincident_evaders_gain_by_parting(count):
    team = covey.Team([(0.5, 0.1)] * count, [0.0] * count)
    disk = covey.PursuerDisk()
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    alone = covey.plan(covey.Team([(0.5, 0.1)], [0.0]), disk)
    assert plan.survival_time > alone.survival_time * (1.0 + 0.05 * (count - 1))


@pytest.mark.parametrize("count", [1, 2, 4])
def test_evaders_in_the_disk_at_the_start(count):
    """One may be captured at time 0; alone it is lost, the others have still to be reached."""
    generator = np.random.default_rng(count)
    team = covey.Team(generator.uniform(-0.2, 0.2, (count, 2)), generator.uniform(-3, 3, count))
    disk = covey.PursuerDisk(radius=0.5)
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    first = covey.capture_times(team, disk, plan.turns, plan.critical_sequences[0])[0]
    assert first == 0.0
    assert (plan.survival_time == 0.0) == (count == 1)


def test_all_within_reach_at_the_start():
    team = covey.Team([(0.01, 0.0), (0.0, 0.01), (-0.01, 0.0)], [0.0, 1.0, 2.0])
    disk = covey.PursuerDisk(capture_radius=0.1)
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    assert plan.survival_time == 0.0


def test_half_turns_to_either_side_are_different_plans(frame):
    """Facing the pursuer and beside its line: a half turn away from it, not towards it."""
    team, disk = frame.game(covey.Team([(2.0, 0.3)], [math.pi]), covey.PursuerDisk())
    plan = covey.plan(team, disk)
    assert_valid(plan, team, disk)
    values = [covey.guaranteed_survival(team, disk, [turn]).time for turn in (math.pi, -math.pi)]
    assert abs(values[0] - values[1]) > 0.1
    assert plan.survival_time >= max(values)
    assert np.sign(plan.turns[0]) == (1.0 if values[0] > values[1] else -1.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_plan_may_end_at_a_half_turn(frame, side):
    """A limit of the turn that holds the best one back: it is reached, and the search converges."""
    team, disk = frame.game(covey.Team([(2.0, -0.4 * side)], [math.pi]), covey.PursuerDisk())
    grid = np.linspace(0.0, math.pi, 2001)
    values = [covey.guaranteed_survival(team, disk, [side * turn]).time for turn in grid]
    warm = covey.plan(team, disk, starts=1, warm_start=[side * 3.0])
    assert warm.survival_time >= max(values) * (1.0 - SOLVED)
    assert warm.status is covey.PlanStatus.CONVERGED
    assert_valid(warm, team, disk)


@pytest.mark.parametrize("seed", range(10))
def test_heterogeneous_teams(seed):
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 4, radius=0.05, capture_radius=0.01, mixed=True)
    plan = covey.plan(team, disk, starts=8)
    assert_valid(plan, team, disk)
    for _ in range(200):
        turns = random_turns(generator, 4)
        assert covey.guaranteed_survival(team, disk, turns).time <= plan.survival_time


def test_twelve_evaders_from_one_start():
    generator = np.random.default_rng(12)
    team, disk = random_game(generator, 12)
    plan = covey.plan(team, disk, starts=1)
    assert_valid(plan, team, disk)
    away = away_from(disk.center, team.positions)
    radial = covey.guaranteed_survival(team, disk, covey.turns_to(team, away)).time
    assert plan.status is covey.PlanStatus.CONVERGED
    assert plan.survival_time > 1.02 * radial
