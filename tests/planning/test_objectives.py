"""Plans for other objectives than the last capture, beside general optimisers and by hand."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.optimize import minimize

import covey
from kernels import reference_game
from random_games import fleeing, random_game

TOTAL = covey.TotalSurvival()
OBJECTIVES = [
    covey.LastCapture(),
    TOTAL,
    covey.ExpectedSurvival(),
    covey.ExpectedSurvival(measure="last"),
]


def worth(team, disk, turns, objective):
    if isinstance(objective, covey.ExpectedSurvival):
        return covey.expected_survival(team, disk, turns, objective)
    return covey.guaranteed_survival(team, disk, turns, objective=objective).time


def sums(team, disk, turns):
    """The sum of the capture times in each of the N! sequences."""
    orders = reference_game.every_sequence(len(team))
    return np.array([covey.capture_times(team, disk, turns, order).sum() for order in orders])


def best_of(value, count, starts, seed=0):
    """The largest `value` of the turns that a method without derivatives climbs to."""
    generator = np.random.default_rng(seed)
    options = {"xatol": 1e-9, "fatol": 1e-12, "maxiter": 4000, "maxfev": 4000}
    bounds = [(-math.pi, math.pi)] * count
    found = (
        minimize(
            lambda turns: -value(turns),
            generator.uniform(-1.5, 1.5, count),
            method="Nelder-Mead",
            bounds=bounds,
            options=options,
        )
        for _ in range(starts)
    )
    return max(-each.fun for each in found)


@pytest.mark.parametrize("objective", OBJECTIVES, ids=str)
def test_one_evader_flees_whatever_the_objective(objective):
    team, disk = fleeing(0.9), covey.PursuerDisk()
    plan = covey.plan(team, disk, objective=objective)
    assert plan.value == pytest.approx(plan.survival_time, rel=1e-12)
    assert plan.value == pytest.approx(covey.plan(team, disk).survival_time, rel=1e-9)
    assert plan.objective is objective


@pytest.mark.parametrize("objective", OBJECTIVES, ids=str)
@pytest.mark.parametrize("count", [2, 4])
def test_the_value_is_what_the_turns_are_worth(objective, count):
    generator = np.random.default_rng(count)
    for reach in (0.0, 0.02):
        team, disk = random_game(generator, count, capture_radius=reach, mixed=True)
        plan = covey.plan(team, disk, objective=objective, starts=8)
        guaranteed = covey.guaranteed_survival(team, disk, plan.turns)
        assert plan.survival_time == guaranteed.time
        value = worth(team, disk, plan.turns, objective)
        assert plan.value == pytest.approx(value, rel=1e-13)
        assert sum(plan.weights) == pytest.approx(1.0)
        if isinstance(objective, covey.ExpectedSurvival):
            assert len(plan.weights) == math.factorial(count)


@pytest.mark.parametrize("seed", range(4))
def test_the_sum_is_as_large_as_a_general_optimiser_makes_it(seed):
    team, disk = random_game(np.random.default_rng(seed), 3)
    plan = covey.plan(team, disk, objective=TOTAL)
    assert plan.value == pytest.approx(sums(team, disk, plan.turns).min(), rel=1e-13)
    other = best_of(lambda turns: sums(team, disk, turns).min(), 3, starts=4)
    assert plan.value >= other * (1.0 - 1e-7)


@pytest.mark.parametrize("measure", ["last", "total"])
@pytest.mark.parametrize("seed", range(3))
def test_an_expectation_is_as_large_as_a_general_optimiser_makes_it(seed, measure):
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3, radius=0.1)
    orders = reference_game.every_sequence(3)[:4]
    weights = generator.uniform(0.0, 1.0, 4)
    objective = covey.ExpectedSurvival(orders, weights, measure)

    def mean(turns):
        times = np.array([covey.capture_times(team, disk, turns, order) for order in orders])
        measured = times.sum(axis=1) if measure == "total" else times[:, -1]
        return float(weights @ measured) / weights.sum()

    plan = covey.plan(team, disk, objective=objective)
    assert plan.value == pytest.approx(mean(plan.turns), rel=1e-13)
    assert plan.value >= best_of(mean, 3, starts=4) * (1.0 - 1e-7)


@pytest.mark.parametrize("objective", OBJECTIVES[1:], ids=str)
def test_no_neighbour_is_better(objective):
    """Where an ascent says that it converged, no small change of the turns gains anything."""
    generator = np.random.default_rng(8)
    for _ in range(6):
        team, disk = random_game(generator, 4)
        plan = covey.plan(team, disk, objective=objective)
        assert plan.status is covey.PlanStatus.CONVERGED
        for size in (1e-2, 1e-4):
            for move in generator.normal(0.0, size, (40, 4)):
                turns = np.clip(plan.turns + move, -math.pi, math.pi)
                assert worth(team, disk, turns, objective) <= plan.value * (1.0 + 1e-8)


def test_each_objective_gets_most_of_its_own():
    generator = np.random.default_rng(2)
    for _ in range(10):
        team, disk = random_game(generator, 4)
        last, total, expected, _ = (covey.plan(team, disk, objective=o) for o in OBJECTIVES)
        assert last.survival_time >= total.survival_time * (1.0 - 1e-9)
        assert last.survival_time >= expected.survival_time * (1.0 - 1e-9)
        for other in (last, expected):
            assert total.value >= worth(team, disk, other.turns, TOTAL) * (1.0 - 1e-9)
        for other in (last, total):
            assert expected.value >= worth(team, disk, other.turns, OBJECTIVES[2]) * (1.0 - 1e-9)


def test_a_certain_sequence_is_the_fixed_sequence_problem():
    """All weight on one sequence, and the last capture: what `plan_for_sequence` solves exactly."""
    generator = np.random.default_rng(4)
    for _ in range(5):
        team, disk = random_game(generator, 3)
        sequence = generator.permutation(3).tolist()
        objective = covey.ExpectedSurvival([sequence, sequence[::-1]], [2.0, 0.0], "last")
        known = covey.plan_for_sequence(team, disk, sequence)
        assert covey.plan(team, disk, objective=objective).value == pytest.approx(
            known.survival_time, rel=1e-6
        )


def test_weights_are_relative():
    team, disk = random_game(np.random.default_rng(0), 2)
    plans = [
        covey.plan(team, disk, objective=covey.ExpectedSurvival([(0, 1), (1, 0)], weights))
        for weights in ([1.0, 3.0], [100.0, 300.0])
    ]
    assert plans[0].turns.tolist() == plans[1].turns.tolist()
    assert plans[0].critical_sequences == ((1, 0), (0, 1))
    assert plans[0].weights == pytest.approx((0.75, 0.25))


@pytest.mark.parametrize("objective", OBJECTIVES[1:], ids=str)
def test_a_warm_start_is_never_lost(objective):
    generator = np.random.default_rng(6)
    for _ in range(5):
        team, disk = random_game(generator, 3)
        first = covey.plan(team, disk, objective=objective, starts=2)
        for warm_start in (first, first.turns, covey.plan(team, disk, starts=2)):
            again = covey.plan(team, disk, objective=objective, starts=1, warm_start=warm_start)
            turns = getattr(warm_start, "turns", warm_start)
            assert again.value >= worth(team, disk, turns, objective) * (1.0 - 1e-12)


def test_large_teams_are_planned_side_by_side_for_the_sum():
    team, disk = random_game(np.random.default_rng(1), 9)
    plan = covey.plan(team, disk, objective=TOTAL, starts=2)
    assert plan.value == covey.guaranteed_survival(team, disk, plan.turns, objective=TOTAL).time


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: covey.ExpectedSurvival([]), "expected at least one"),
        (lambda: covey.ExpectedSurvival([(0, 2)]), "each evader 0..1 once"),
        (lambda: covey.ExpectedSurvival([(0, 1), (0, 1, 2)]), "each evader 0..1 once"),
        (lambda: covey.ExpectedSurvival([(0.5, 1)]), "each evader 0..1 once"),
        (lambda: covey.ExpectedSurvival([(0, "a")]), "each evader 0..1 once"),
        (lambda: covey.ExpectedSurvival([[0, [1]]]), "each evader 0..1 once"),
        (lambda: covey.ExpectedSurvival(3), "sequences: expected a list, got 3"),
        (lambda: covey.ExpectedSurvival([(0, 1)], 2.0), "weights: expected a list, got 2.0"),
        (lambda: covey.ExpectedSurvival([(0, 1), (0, 1)]), "got one twice"),
        (lambda: covey.ExpectedSurvival([(0, 1)], [1.0, 2.0]), "one for each of 1 sequences"),
        (lambda: covey.ExpectedSurvival([(0, 1)], [-1.0]), ">= 0"),
        (lambda: covey.ExpectedSurvival([(0, 1)], [math.nan]), "finite"),
        (lambda: covey.ExpectedSurvival([(0, 1)], [0.0]), "at least one > 0"),
        (lambda: covey.ExpectedSurvival(None, [1.0]), "none without sequences"),
        (lambda: covey.ExpectedSurvival(measure="first"), "one of last, total"),
    ],
)
def test_wrong_expectations_say_what_was_wanted(make, message):
    with pytest.raises(covey.InputError, match=message):
        make()


def test_an_objective_must_fit_the_team():
    team, disk = random_game(np.random.default_rng(0), 3)
    for objective, message in (
        (covey.ExpectedSurvival([(0, 1)]), "sequences of all 3 evaders"),
        ("total", "expected one of last-capture, total-survival, expected-survival, got 'total'"),
        (covey.TotalSurvival, "expected LastCapture"),
    ):
        with pytest.raises(covey.InputError, match=message):
            covey.plan(team, disk, objective=objective)
    many, disk = random_game(np.random.default_rng(0), 9)
    with pytest.raises(covey.InputError, match="too many"):
        covey.plan(many, disk, objective=covey.ExpectedSurvival())
    with pytest.raises(covey.InputError, match="guarantees nothing"):
        covey.guaranteed_survival(team, disk, np.zeros(3), objective=covey.ExpectedSurvival())
    with pytest.raises(covey.InputError, match="expected ExpectedSurvival"):
        covey.expected_survival(team, disk, np.zeros(3), TOTAL)


def test_a_name_stands_for_the_objective_with_its_defaults():
    team, disk = random_game(np.random.default_rng(0), 2)
    for name, objective in (
        ("last-capture", covey.LastCapture()),
        ("total-survival", TOTAL),
        ("expected-survival", covey.ExpectedSurvival()),
    ):
        plan = covey.plan(team, disk, objective=name, starts=2)
        assert plan == covey.plan(team, disk, objective=objective, starts=2)
    by_name = covey.guaranteed_survival(team, disk, plan.turns, objective="total-survival")
    assert by_name == covey.guaranteed_survival(team, disk, plan.turns, objective=TOTAL)
    game = covey.simulate(team, disk, objective="total-survival", update_time=0.1)
    assert game.objective == TOTAL.describe()
    for team_of_two in ("open-loop", "hold-course"):
        arguments = {"evaders": team_of_two, "update_time": 0.1}
        worst = covey.worst_case(team, disk, objective="total-survival", **arguments)
        assert worst == covey.worst_case(team, disk, objective=TOTAL, **arguments)
        assert worst.value == pytest.approx(sum(worst.capture_times))


def test_the_best_order_is_another_for_the_sum():
    """A near evader and two far ones, close together, on the other side; nobody moves.

    For the last capture it pays to take the near one first, for the sum the two.
    """
    team = covey.Team([(-0.9, 0.0), (1.0, 0.0), (1.0, 0.1)], [0.0] * 3, 0.0)
    disk = covey.PursuerDisk()
    last = covey.guaranteed_survival(team, disk, np.zeros(3))
    total = covey.guaranteed_survival(team, disk, np.zeros(3), objective=TOTAL)
    by_hand = {
        order: np.cumsum(
            [
                math.dist(a, b)
                for a, b in itertools.pairwise([(0.0, 0.0), *(team.positions[i] for i in order)])
            ]
        )
        for order in itertools.permutations(range(3))
    }
    assert last.sequence == min(by_hand, key=lambda order: by_hand[order][-1]) == (0, 1, 2)
    assert total.sequence == min(by_hand, key=lambda order: by_hand[order].sum()) == (1, 2, 0)
    assert last.time == pytest.approx(by_hand[last.sequence][-1], rel=1e-14)
    assert total.time == pytest.approx(by_hand[total.sequence].sum(), rel=1e-14)


@pytest.mark.parametrize("objective", OBJECTIVES, ids=str)
@pytest.mark.parametrize("count", [1, 2])
def test_straight_into_the_pursuer_is_left(objective, count):
    """There no gradient is left, but it is a minimum."""
    team = covey.Team([(0.3, 0.0), (-0.4, 0.0)][:count], [0.0, math.pi][:count], 0.25, math.inf)
    disk = covey.PursuerDisk()
    stuck = covey.plan(
        team, disk, objective=objective, starts=1, warm_start=np.full(count, math.pi)
    )
    assert stuck.value == pytest.approx(covey.plan(team, disk, objective=objective).value, rel=1e-6)
