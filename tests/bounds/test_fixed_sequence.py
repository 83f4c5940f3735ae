"""The flight against a known sequence: hand cases, a general optimiser, the root search of [8]."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.optimize import brentq, differential_evolution

import covey
from covey.kernels.bounds.fixed_sequence import (
    best_on_grid,
    latest_in_sequence,
    lay_grid,
    new_grid,
    new_grids,
)
from covey.model.angles import wrap_angle
from covey.planning.border import pursuit_of
from random_games import fleeing, random_game


def at_once(team):
    """The same team with unlimited turn rates."""
    return covey.Team(team.positions, team.headings, team.speeds, math.inf)


def test_one_evader_flees_straight(frame):
    disk = covey.PursuerDisk((0, 0), 0.1, 1.0, 0.05)
    plan = covey.plan_for_sequence(*frame.game(fleeing(1.2), disk), [0])
    assert plan.survival_time == pytest.approx(frame.time * (1.2 - 0.1 - 0.05) / 0.75, rel=1e-14)
    assert plan.turns.tolist() == [0.0]
    assert plan.status.name == "CONVERGED"


def test_one_that_stands_between_dodges_to_the_side_that_leads_away_from_the_next(frame):
    places = np.array([[1.0, 0.02], [2.0, 0.0]])
    team, mirrored = (
        frame.team(covey.Team(each, [0.0, 0.0], 0.25, math.inf))
        for each in (places, places * [1, -1])
    )
    disk = frame.disk(covey.PursuerDisk())
    up = covey.plan_for_sequence(team, disk, [0, 1])
    down = covey.plan_for_sequence(mirrored, disk, [0, 1])
    assert up.turns[0] > 0.5
    assert down.turns[0] == pytest.approx(-up.turns[0], abs=1e-6)
    # Dodging downward is a local maximum too, and a lower one.
    other = up.turns * [-1, 1]
    assert covey.capture_times(team, disk, other, [0, 1])[-1] < up.survival_time


def test_the_last_flees_straight_from_the_capture_before_its_own():
    team, disk = random_game(np.random.default_rng(5), 4)
    team = at_once(team)
    plan = covey.plan_for_sequence(team, disk, [2, 0, 3, 1])
    heading = plan.goal_headings[3]
    place = team.positions[3] + 0.25 * plan.capture_times[2] * unit(heading)
    flight = team.positions[1] - place
    assert math.atan2(flight[1], flight[0]) == pytest.approx(plan.goal_headings[1], abs=1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_equals_a_general_optimiser(seed):
    generator = np.random.default_rng(seed)
    count = 2 + seed % 3
    team, disk = random_game(
        generator, count, mixed=seed % 2 == 0, radius=0.1 * (seed % 3), capture_radius=0.01 * seed
    )
    sequence = generator.permutation(count)
    plan = covey.plan_for_sequence(team, disk, sequence)
    found = differential_evolution(
        lambda turns: -covey.capture_times(team, disk, turns, sequence)[-1],
        [(-math.pi, math.pi)] * count,
        seed=seed,
        tol=1e-10,
    )
    assert plan.survival_time == pytest.approx(-found.fun, rel=1e-9)
    assert plan.capture_times.tolist() == (
        covey.capture_times(team, disk, plan.turns, sequence).tolist()
    )


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("speed", [0.25, 0.6])
def test_equals_the_best_root_of_the_stationarity_conditions(seed, speed):
    """Belousov et al.: with unlimited turn rates one unknown, the first heading, is enough."""
    generator = np.random.default_rng(seed)
    count = 2 + seed % 3
    places = generator.uniform(-0.5, 0.5, (count, 2))
    team = covey.Team(places, np.zeros(count), speed, math.inf)
    sequence = generator.permutation(count)
    plan = covey.plan_for_sequence(team, covey.PursuerDisk(), sequence)
    roots = stationary_times(places[sequence], speed)
    assert plan.survival_time == pytest.approx(max(roots), rel=1e-9)


@pytest.mark.parametrize("count", [1, 2, 3, 5, 8])
@pytest.mark.parametrize("speed", [0.25, 0.9])
def test_unlimited_turns_are_the_root_near_which_finer_and_finer_grids_end(count, speed):
    for seed in range(10):
        generator = np.random.default_rng(seed)
        team, disk = random_game(
            generator, count, radius=0.1 * (seed % 2), capture_radius=0.01 * (seed % 3)
        )
        team = covey.Team(team.positions, team.headings, speed, math.inf)
        sequence = generator.permutation(count)
        plan = covey.plan_for_sequence(team, disk, sequence)
        refined = np.zeros(count)
        grids = new_grids(team.as_rows())
        assert latest_in_sequence(pursuit_of(disk), sequence, 1e-9, grids, refined)
        times = covey.capture_times(team, disk, wrap_angle(refined), sequence)
        assert plan.survival_time == pytest.approx(times[-1], rel=1e-13)
        assert np.abs(wrap_angle(plan.turns - refined)).max() < 1e-6
        assert misalignment(team, disk, plan) < 1e-12


@pytest.mark.parametrize(
    ("center", "on_border"), [(0.4, True), (-0.4, True), (0.3, False), (-0.3, False)]
)
def test_a_search_does_not_narrow_while_the_best_turn_is_on_either_border(center, on_border):
    """Straight on is best; the nine turns of the grid are 0.1 apart."""
    team, disk = covey.Team([[1.0, 0.0]], [0.0]), covey.PursuerDisk()
    grid, turns = new_grid(team.as_rows(), 9), np.zeros(1)
    lay_grid(grid, np.array([center]), 0.4, disk.speed)
    found = best_on_grid(grid, pursuit_of(disk), np.zeros(1, np.int64), turns)
    assert turns == pytest.approx([0.0], abs=1e-12)
    assert found == on_border


def misalignment(team, disk, plan):
    """Largest angle, as a sine, between a heading and λ_k n_k - λ_{k+1} n_{k+1}."""
    order = list(plan.sequence)
    flown = team.speeds[0] * np.array([unit(heading) for heading in plan.goal_headings[order]])
    places = team.positions[order] + flown * plan.capture_times[:, None]
    ways = np.diff([disk.center, *places], axis=0)
    normals = ways / np.hypot(*ways.T)[:, None]
    normals[np.diff(plan.capture_times, prepend=0.0) == 0.0] = 0.0  # it was in the disk already
    sines, later, normal_later = [], 0.0, np.zeros(2)
    backwards = zip(normals[::-1], flown[::-1], plan.capture_times[::-1], strict=True)
    for normal, velocity, time in backwards:
        delays = later * (disk.speed - normal_later @ velocity) if later else 1.0
        now = delays / (disk.speed - normal @ velocity)
        goal = now * normal - later * normal_later
        if time > 0.0:
            across = goal[0] * velocity[1] - goal[1] * velocity[0]
            sines.append(abs(across) / (np.hypot(*goal) * np.hypot(*velocity)))
        later, normal_later = now, normal
    return max(sines, default=0.0)


def stationary_times(places, speed):
    """Last capture times of all stationary straight flights, for a pursuer of speed 1 from 0."""
    best = []
    for exits in itertools.product([False, True], repeat=max(len(places) - 2, 0)):
        headings = np.linspace(-math.pi, math.pi, 20_001)
        misses = np.array([shoot(heading, places, speed, exits)[0] for heading in headings])
        crossing = np.flatnonzero((misses[:-1] * misses[1:] < 0) & (abs(np.diff(misses)) < 0.5))
        for k in crossing:
            root = brentq(
                lambda heading, exits=exits: shoot(heading, places, speed, exits)[0],
                headings[k],
                headings[k + 1],
                xtol=1e-14,
            )
            miss, ahead, time = shoot(root, places, speed, exits)
            if abs(miss) < 1e-9 and ahead > 0.0:
                best.append(time)
    return best


def shoot(heading, places, speed, exits):
    """Follow the pursuer from evader to evader for the first one's heading.

    At each capture the pursuer's way is reflected as off a mirror that moves with the evader: with
    α the angle from the evader's heading, tan(α/2) tan(α'/2) = (v_p - v) / (v_p + v). Returns by
    how much it misses the last evader's place (0: that one flees straight), how far ahead that
    place is, and the last capture time.
    """
    along = unit(heading)
    first = places[0]
    b = speed * first @ along
    time = (b + math.sqrt(b * b + (1 - speed**2) * first @ first)) / (1 - speed**2)
    place, normal = (
        first + speed * time * along,
        unit(math.atan2(*(first / time + speed * along)[::-1])),
    )
    for k, target in enumerate(places[1:], start=1):
        angle = math.atan2(along[0] * normal[1] - along[1] * normal[0], along @ normal)
        if angle == 0.0:
            return math.nan, 0.0, 0.0
        angle = 2 * math.atan((1 - speed) / (1 + speed) / math.tan(angle / 2))
        normal = unit(math.atan2(along[1], along[0]) + angle)
        off = target - place
        if k == len(places) - 1:
            distance = math.hypot(*off)
            miss = (normal[0] * off[1] - normal[1] * off[0]) / distance
            return miss, normal @ off, (time + distance) / (1 - speed)
        # |s normal - off| = speed (time + s): where the ray enters the evader's reach, or exits.
        half = normal @ off + speed**2 * time
        under = half**2 - (1 - speed**2) * (off @ off - (speed * time) ** 2)
        if under < 0.0:
            return math.nan, 0.0, 0.0
        flown = (half + (1 if exits[k - 1] else -1) * math.sqrt(under)) / (1 - speed**2)
        if flown <= 0.0:
            return math.nan, 0.0, 0.0
        place, time = place + flown * normal, time + flown
        along = (place - target) / (speed * time)
    raise AssertionError("a team of one has no root to search")


def unit(angle):
    return np.array([math.cos(angle), math.sin(angle)])


@pytest.mark.parametrize(
    ("sequence", "message"),
    [([0, 0, 1], "each evader 0..2 once"), ([0, 1], "each evader"), ("abc", "each evader")],
)
def test_rejects_what_is_no_sequence(sequence, message):
    team, disk = random_game(np.random.default_rng(0), 3)
    with pytest.raises(covey.InputError, match=message):
        covey.plan_for_sequence(team, disk, sequence)


def test_rejects_an_evader_as_fast_as_the_pursuer():
    team, _ = random_game(np.random.default_rng(0), 3)
    with pytest.raises(covey.InputError, match="slower than the pursuer"):
        covey.plan_for_sequence(team, covey.PursuerDisk(speed=0.25), [0, 1, 2])


@pytest.mark.parametrize("mixed", [False, True])
def test_turns_are_at_most_half_turns_whatever_the_headings_without_a_turn_limit(mixed):
    """The search may wind round; only the direction counts for who turns at once."""
    for seed in range(30):
        generator = np.random.default_rng(seed)
        team, disk = random_game(generator, 3)
        rates = [math.inf, 1.0, math.inf] if mixed else math.inf
        headings = generator.uniform(-9.0, 9.0, 3)
        team = covey.Team(team.positions, headings, team.speeds, rates)
        plan = covey.plan_for_sequence(team, disk, generator.permutation(3))
        assert np.abs(plan.turns).max() <= math.pi
        reached = wrap_angle(team.headings + plan.turns - plan.goal_headings)
        assert np.abs(reached).max() < 1e-12
