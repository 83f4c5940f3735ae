"""The least sum of capture times: against N! trials, and against what a simpler state would say."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings

import covey
from kernels import kernel_calls, reference_game
from random_games import games, random_game, random_turns, time_rounding

TOTAL = covey.TotalSurvival()


def sums_of_all(team, disk, turns):
    sequences = reference_game.every_sequence(len(team))
    return {each: float(covey.capture_times(team, disk, turns, each).sum()) for each in sequences}


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 6])
@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.2, 0.0), (0.0, 0.05), (0.2, 0.1)])
@pytest.mark.parametrize("mixed", [False, True])
def test_equals_the_least_of_all_sequences(count, radius, reach, mixed):
    generator = np.random.default_rng([count, round(100 * radius), round(100 * reach), mixed])
    for _ in range(2 if count == 6 else 10):
        team, disk = random_game(generator, count, radius=radius, capture_radius=reach, mixed=mixed)
        turns = random_turns(generator, count)
        sums = sums_of_all(team, disk, turns)
        least = covey.guaranteed_survival(team, disk, turns, objective=TOTAL)
        assert least.time == pytest.approx(min(sums.values()), rel=1e-13)
        assert sums[least.sequence] == pytest.approx(least.time, rel=1e-13)


@given(games(most=4))
@settings(max_examples=100)
def test_equals_the_least_of_all_sequences_at_every_scale(game):
    team, disk, turns = game
    least = covey.guaranteed_survival(team, disk, turns, objective=TOTAL)
    rounding = len(team) * time_rounding(team, disk, least.time)
    expected = min(sums_of_all(team, disk, turns).values())
    assert least.time == pytest.approx(expected, abs=rounding, rel=0.0)


@pytest.mark.parametrize("reach", [0.0, 0.05])
@pytest.mark.parametrize("count", [2, 5, 9])
def test_a_bound_hides_nothing_below_it(count, reach):
    generator = np.random.default_rng([count, round(100 * reach)])
    for _ in range(20):
        team, disk = random_game(generator, count, capture_radius=reach, mixed=True)
        turns = random_turns(generator, count)
        least, sequence = kernel_calls.least_sum(team, disk, turns)
        for bound in (1.5 * least, 1.001 * least, np.nextafter(least, math.inf)):
            found = kernel_calls.least_sum(team, disk, turns, bound)
            assert (found[0], found[1].tolist()) == (least, sequence.tolist())
        for bound in (least, 0.9 * least):
            kept = np.arange(count)[::-1]
            found = kernel_calls.least_sum(team, disk, turns, bound, kept)
            assert (found[0], found[1].tolist()) == (bound, kept.tolist())


def least_with_single_labels(team, disk, turns, better):
    """Held and Karp's programme with one beginning for each set and last captured: the `better`."""
    n = len(team)

    def times(sequence):
        rest = [i for i in range(n) if i not in sequence]
        return covey.capture_times(team, disk, turns, (*sequence, *rest))[: len(sequence)]

    labels = {(frozenset([i]), i): (i,) for i in range(n)}
    for _ in range(n - 1):
        longer = {}
        for (caught, _), sequence in labels.items():
            for i in set(range(n)) - caught:
                state, candidate = (caught | {i}, i), (*sequence, i)
                smaller = np.sum if len(candidate) == n else better
                if state not in longer or smaller(times(candidate)) < smaller(times(longer[state])):
                    longer[state] = candidate
        labels = longer
    return min(times(sequence).sum() for sequence in labels.values())


def test_neither_the_earliest_arrival_nor_the_smallest_sum_is_state_enough():
    """There are games in which a programme with a single label comes out too high, so a bound.

    With four evaders or more: with three, the first two captures leave one order for each state.
    """
    generator = np.random.default_rng(5)
    missed = {"earliest": 0, "smallest": 0}
    for _ in range(60):
        team, disk = random_game(generator, 5)
        turns = random_turns(generator, 5)
        least = covey.guaranteed_survival(team, disk, turns, objective=TOTAL).time
        for name, better in (("earliest", lambda times: times[-1]), ("smallest", np.sum)):
            single = least_with_single_labels(team, disk, turns, better)
            assert single >= least * (1.0 - 1e-13)
            missed[name] += single > least * (1.0 + 1e-9)
    assert missed["earliest"] > 0
    assert missed["smallest"] > 0


def test_up_to_three_evaders_a_single_label_is_enough():
    generator = np.random.default_rng(6)
    for _ in range(30):
        team, disk = random_game(generator, 3)
        turns = random_turns(generator, 3)
        least = covey.guaranteed_survival(team, disk, turns, objective=TOTAL).time
        single = least_with_single_labels(team, disk, turns, lambda times: times[-1])
        assert single == pytest.approx(least, rel=1e-13)


@pytest.mark.parametrize("count", [7, 8])
def test_more_pairs_than_are_remembered_cost_no_exactness(count):
    generator = np.random.default_rng(count)
    team, disk = random_game(generator, count, capture_radius=0.01)
    turns = random_turns(generator, count)
    least, _ = kernel_calls.least_sum(team, disk, turns)
    assert least == pytest.approx(min(sums_of_all(team, disk, turns).values()), rel=1e-13)
