import math
from itertools import pairwise

import numpy as np
import pytest

import covey
from covey.bounds.announced_sequence import best_announcement
from covey.bounds.next_capture import next_capture_bound
from covey.bounds.polygon_bound import last_capture_bound
from covey.model.angles import unit_vectors


def game(seed, evaders=4, speed=0.5, reach=0.0):
    positions = np.random.default_rng(seed).uniform(-1.0, 1.0, (evaders, 2))
    team = covey.Team(positions, np.zeros(evaders), speed, math.inf)
    return team, covey.PursuerDisk((0.1, -0.2), 0.0, 1.0, reach)


def announced(team, disk):
    """The bound for a pursuer that announces its whole sequence."""
    point = covey.PursuerDisk(disk.center, 0.0, disk.speed)
    return last_capture_bound(team, disk, best_announcement(team, point, []))


def bound_of(team, disk):
    found = next_capture_bound(team, disk, announced(team, disk))
    assert found is not None
    return found


IMPROVED = [(2, 3), (10, 3), (9, 4), (12, 4)]
"""Seeds and numbers of evaders of games in which announcing less is better."""


def until_the_first_capture(team, disk, first, legs):
    """When the first evader is captured, and where all are then, the pursuer last.

    Each leg is a duration, headings and speeds. The line of sight keeps its bearing.
    """
    positions, pursuer, now = team.positions.copy(), disk.center, 0.0
    for duration, headings, speeds in legs:
        velocities = speeds[:, np.newaxis] * unit_vectors(headings)
        sight = positions[first] - pursuer
        distance = np.hypot(*sight)
        along = sight / distance
        receding = velocities[first] @ along
        across = velocities[first] - receding * along
        ahead = math.sqrt(disk.speed**2 - across @ across)
        time = min(duration, distance / (ahead - receding))
        positions = positions + time * velocities
        pursuer, now = pursuer + time * (across + ahead * along), now + time
    return now, positions, pursuer


def mean_last_capture(team, disk, found, legs):
    """The mean over the orders, if those left fly as well as they can after the first capture."""
    now, positions, pursuer = until_the_first_capture(team, disk, found.first, legs)
    latest = []
    for order in found.orders:
        left = covey.Team(positions[list(order)], np.zeros(len(order)), 0.5, math.inf)
        start = covey.PursuerDisk(pursuer, 0.0, disk.speed)
        plan = covey.plan_for_sequence(left, start, range(len(order)))
        latest.append(now + plan.survival_time)
    return found.weights @ latest


@pytest.mark.parametrize(("seed", "evaders"), IMPROVED)
def test_no_flight_until_the_first_capture_exceeds_the_bound(seed, evaders):
    generator = np.random.default_rng(seed)
    team, disk = game(seed, evaders)
    found = bound_of(team, disk)
    for legs in generator.integers(1, 5, 25):
        durations = [*generator.uniform(0.0, 0.3, legs - 1), math.inf]
        flown = [
            (
                duration,
                generator.uniform(-math.pi, math.pi, evaders),
                team.speeds * generator.uniform(0.0, 1.0, evaders) ** 0.2,
            )
            for duration in durations
        ]
        assert mean_last_capture(team, disk, found, flown) <= found.time * (1.0 + 1e-9)


@pytest.mark.parametrize(("seed", "evaders"), IMPROVED)
def test_a_straight_flight_comes_close_to_the_bound(seed, evaders):
    generator = np.random.default_rng(seed)
    team, disk = game(seed, evaders)
    found = bound_of(team, disk)

    def mean(headings):
        return mean_last_capture(team, disk, found, [(math.inf, headings, team.speeds)])

    best = 0.0
    for _ in range(3):
        headings, step = generator.uniform(-math.pi, math.pi, evaders), 0.8
        latest = mean(headings)
        for _ in range(50):
            trial = headings + step * generator.normal(size=evaders)
            if (value := mean(trial)) > latest:
                headings, latest, step = trial, value, 1.3 * step
            else:
                step *= 0.9
        best = max(best, latest)
    assert 0.9 * found.time < best <= found.time * (1.0 + 1e-9)


@pytest.mark.parametrize(("seed", "evaders"), IMPROVED)
def test_is_below_the_bound_that_is_known_and_above_a_guarantee(seed, evaders):
    team, disk = game(seed, evaders)
    found = bound_of(team, disk)
    assert covey.plan(team, disk).survival_time <= found.time < announced(team, disk)


@pytest.mark.parametrize(("seed", "evaders"), IMPROVED)
def test_names_an_evader_and_weighs_orders_of_all_others(seed, evaders):
    team, disk = game(seed, evaders)
    found = bound_of(team, disk)
    assert len(found.orders) == len(found.weights) == len(set(found.orders))
    assert all(sorted([found.first, *order]) == list(range(evaders)) for order in found.orders)
    assert found.weights.min() > 0.0
    assert found.weights.sum() == pytest.approx(1.0)


def test_does_not_depend_on_the_frame(frame):
    team, disk = game(12)
    there = bound_of(frame.team(team), frame.disk(disk))
    assert there.time / frame.time == pytest.approx(bound_of(team, disk).time, rel=4e-3)


def test_a_longer_reach_captures_earlier():
    times = [bound_of(*game(12, reach=reach)).time for reach in (0.0, 0.05, 0.1)]
    assert all(later < earlier for earlier, later in pairwise(times))


def test_turn_rates_and_headings_do_not_matter():
    team, disk = game(12)
    slow = covey.Team(team.positions, [1.0, 2.0, 3.0, -1.0], team.speeds, 0.1)
    here, there = bound_of(team, disk), next_capture_bound(slow, disk, announced(team, disk))
    assert there is not None
    assert there.time == here.time


@pytest.mark.parametrize("evaders", [1, 2])
def test_one_and_two_evaders_leave_nothing_to_choose(evaders):
    assert next_capture_bound(*game(0, evaders), math.inf) is None


def test_there_is_no_bound_below_a_guarantee():
    team, disk = game(12)
    assert next_capture_bound(team, disk, covey.plan(team, disk).survival_time) is None


def test_evaders_almost_as_fast_as_the_pursuer_are_not_bounded():
    assert next_capture_bound(*game(12, speed=1.0 - 1e-9), math.inf) is None


def test_an_evader_where_the_pursuer_is_may_be_the_first():
    team, disk = game(12)
    positions = team.positions.copy()
    positions[2] = disk.center
    found = next_capture_bound(covey.Team(positions, np.zeros(4), 0.5, math.inf), disk, math.inf)
    assert found is not None
    assert math.isfinite(found.time)


def test_a_team_that_is_where_the_pursuer_is_is_captured_at_once():
    _, disk = game(0)
    team = covey.Team(np.tile(disk.center, (4, 1)), np.zeros(4), 0.5, math.inf)
    found = next_capture_bound(team, disk, math.inf)
    assert found is not None
    assert found.time == 0.0
