"""The exact minimum over all capture sequences is exact: nothing but N! trials says otherwise."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings

import covey
from kernels import kernel_calls, reference_game
from random_games import games, random_game, random_turns, time_rounding


def least_of_all(team, disk, turns):
    return kernel_calls.times_of_sequences(team, disk, reference_game.every_sequence(len(team)))(
        turns
    ).min()


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 6])
@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.2, 0.0), (0.0, 0.05), (0.2, 0.1)])
@pytest.mark.parametrize("mixed", [False, True])
def test_equals_the_least_of_all_sequences(count, radius, reach, mixed):
    generator = np.random.default_rng([count, round(100 * radius), round(100 * reach), mixed])
    for _ in range(3 if count == 6 else 10):
        team, disk = random_game(generator, count, radius=radius, capture_radius=reach, mixed=mixed)
        turns = random_turns(generator, count)
        guarantee = covey.guaranteed_survival(team, disk, turns)
        assert guarantee.time == least_of_all(team, disk, turns)
        attained = covey.capture_times(team, disk, turns, guarantee.sequence)
        assert attained[-1] == guarantee.time


@given(games(most=4))
@settings(max_examples=150)
def test_equals_the_least_of_all_sequences_at_every_scale(game):
    """Where places coincide, sequences tie but for rounding, which the minimum may resolve."""
    team, disk, turns = game
    guarantee = covey.guaranteed_survival(team, disk, turns)
    rounding = time_rounding(team, disk, guarantee.time)
    assert sorted(guarantee.sequence) == list(range(len(team)))
    assert guarantee.time == pytest.approx(least_of_all(team, disk, turns), abs=rounding, rel=0.0)
    attained = covey.capture_times(team, disk, turns, guarantee.sequence)[-1]
    assert attained == pytest.approx(guarantee.time, abs=rounding, rel=0.0)


@pytest.mark.parametrize("reach", [0.0, 0.02, 0.1])
@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7])
@pytest.mark.parametrize("mixed", [False, True])
def test_a_bound_hides_nothing_below_it(count, reach, mixed):
    """The search for a sequence below a bound finds the least one, however close the bound is.

    With ρ > 0 too, where every capture on the way grants another 2ρ, and a detour can be shorter.
    """
    generator = np.random.default_rng([count, round(100 * reach), mixed])
    for _ in range(25):
        team, disk = random_game(generator, count, capture_radius=reach, mixed=mixed)
        turns = random_turns(generator, count)
        least, sequence = kernel_calls.least(team, disk, turns)
        for bound in (1.5 * least, 1.001 * least, np.nextafter(least, math.inf)):
            below, found = kernel_calls.least(team, disk, turns, bound)
            assert below == least
            assert found.tolist() == sequence.tolist()


@pytest.mark.parametrize("count", [1, 2, 4, 6])
def test_nothing_is_found_below_the_least(count):
    """Then the bound comes back, the sequence stays as it was, and the next search is unharmed."""
    generator = np.random.default_rng(count)
    for _ in range(25):
        team, disk = random_game(generator, count)
        turns, kept = random_turns(generator, count), generator.permutation(count)
        least = covey.guaranteed_survival(team, disk, turns).time
        for bound in (least, 0.9 * least, 0.1 * least, 0.0):
            below, found = kernel_calls.least(team, disk, turns, bound, kept)
            assert below == bound
            assert found.tolist() == kept.tolist()
        assert kernel_calls.least(team, disk, turns)[0] == least


@pytest.mark.parametrize("reach", [0.0, 0.05])
@pytest.mark.parametrize("count", [5, 7, 9])
def test_a_search_with_bounds_ends_with_the_exact_value(count, reach):
    generator = np.random.default_rng(count)
    for _ in range(5):
        team, disk = random_game(generator, count, capture_radius=reach)
        plan = covey.plan(team, disk, starts=2)
        guarantee = covey.guaranteed_survival(team, disk, plan.turns)
        assert plan.survival_time == guarantee.time
        assert guarantee.sequence in plan.critical_sequences


def test_worst_order_of_three_that_stand():
    """On a line at 1, -2 and 3: nearest first costs 1 + 3 + 5, the left one first 2 + 5 in all."""
    team = covey.Team([(1.0, 0.0), (-2.0, 0.0), (3.0, 0.0)], [0.0] * 3, 0.0)
    guarantee = covey.guaranteed_survival(team, covey.PursuerDisk(), [0.0] * 3)
    assert guarantee.time == 7.0
    assert guarantee.sequence == (1, 0, 2)


@pytest.mark.parametrize("count", [12, 18, 20])
def test_large_teams_that_stand_on_a_line(count):
    """With one farthest evader at 1 to the left and the others to the right, up to R: 1 + 1 + R."""
    places = np.zeros((count, 2))
    places[:, 0] = np.linspace(2.0, 7.0, count)
    places[0, 0] = -1.0
    team = covey.Team(places, np.zeros(count), 0.0)
    order = np.argsort(places[:, 0])
    guarantee = covey.guaranteed_survival(team, covey.PursuerDisk(), np.zeros(count))
    assert guarantee.time == pytest.approx(9.0, rel=1e-14, abs=0.0)
    assert guarantee.sequence == tuple(order.tolist())
