"""Games about the sum of survival times, or an expectation: what holds, and who minds."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from random_games import random_game
from soak import custom_pursuers
from soak.same_games import differences

TOTAL = covey.TotalSurvival()
OBJECTIVES = [TOTAL, covey.ExpectedSurvival(), covey.ExpectedSurvival(measure="last")]
PURSUERS = {
    "committed": lambda seed: covey.CommittedPursuer(),
    "changes its mind for nothing": lambda seed: covey.CommittedPursuer(margin=0.0),
    "new random order every time": custom_pursuers.redrawing,
    "nearest first": custom_pursuers.nearest_first,
    "farthest first": custom_pursuers.farthest_first,
    "waits": custom_pursuers.waiting,
    "random sequence": lambda seed: covey.RandomSequence(),
}


@pytest.mark.parametrize("evaders", [covey.OpenLoop(2), covey.IterativeOpenLoop(2, 2)], ids=str)
@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("name", PURSUERS)
def test_no_pursuer_brings_the_sum_below_the_plan(evaders, sensing, name):
    ended = 0
    for seed in range(15):
        generator = np.random.default_rng([seed, len(name)])
        reach = generator.choice([0.0, 0.05])
        team, disk = random_game(generator, int(generator.integers(1, 5)), capture_radius=reach)
        game = covey.simulate(
            team,
            disk,
            evaders=evaders,
            pursuer=PURSUERS[name](seed),
            sensing=sensing,
            objective=TOTAL,
            update_time=0.05,
            seed=seed,
            time_limit=10.0,
        )
        plan = covey.plan(team, disk, objective=TOTAL, seed=seed, starts=2)
        assert game.planned_value == pytest.approx(plan.value, rel=1e-12)
        assert game.value >= game.planned_value - 1e-9
        if math.isfinite(game.value):
            ended += 1
            assert game.value == pytest.approx(game.capture_times.sum(), rel=1e-14)
    assert ended >= 1


@pytest.mark.parametrize("objective", OBJECTIVES, ids=str)
@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("evaders", [covey.OpenLoop(3), covey.IterativeOpenLoop(3, 2)], ids=str)
def test_compiled_and_in_python_they_are_one_game(evaders, sensing, objective):
    generator = np.random.default_rng(1)
    for seed, count in itertools.product(range(4), (2, 4)):
        team, disk = random_game(generator, count, radius=0.1, capture_radius=0.02 * seed)
        pursuer = covey.RandomSequence() if seed % 2 else covey.CommittedPursuer()
        options = {"sensing": sensing, "seed": seed, "update_time": 0.02, "objective": objective}
        compiled = covey.simulate(team, disk, evaders=evaders, pursuer=pursuer, **options)
        in_python = covey.simulate(
            team, disk, evaders=evaders.start(seed), pursuer=pursuer.start(seed), **options
        )
        assert differences(compiled, in_python) == []


@pytest.mark.parametrize("measure", ["total", "last"])
def test_over_all_draws_an_open_loop_team_gets_its_expectation(measure):
    """Each sequence flown by a pursuer that keeps to it, and the mean taken by hand."""
    generator = np.random.default_rng(3)
    for sensing in ("hidden", "visible"):
        team, disk = random_game(generator, 3)
        orders = list(itertools.permutations(range(3)))
        weights = generator.uniform(0.0, 1.0, 6)
        games = [
            covey.simulate(
                team,
                disk,
                evaders=covey.OpenLoop(4),
                pursuer=covey.FixedSequence(order),
                sensing=sensing,
                objective=covey.ExpectedSurvival(orders, weights, measure),
                update_time=0.1,
            )
            for order in orders
        ]
        mean = weights @ [game.value for game in games] / weights.sum()
        assert mean == pytest.approx(games[0].planned_value, rel=1e-9)


def test_over_all_draws_planning_again_brings_more_than_expected():
    """What captures tell of the sequence is worth something."""
    gained = 0
    for seed in range(5):
        team, disk = random_game(np.random.default_rng(seed), 3)
        games = [
            covey.simulate(
                team,
                disk,
                evaders=covey.IterativeOpenLoop(8, 4),
                pursuer=covey.FixedSequence(order),
                objective=covey.ExpectedSurvival(),
            )
            for order in itertools.permutations(range(3))
        ]
        mean = np.mean([game.value for game in games])
        assert mean >= games[0].planned_value * (1.0 - 1e-9)
        gained += mean > games[0].planned_value * 1.001
    assert gained >= 4


def test_captures_rule_out_sequences():
    """After the first capture, the team plans as one that knows which sequences are left."""
    generator = np.random.default_rng(7)
    team, disk = random_game(generator, 4)
    orders, weights = [(2, 0, 1, 3), (2, 3, 1, 0), (0, 1, 2, 3)], [1.0, 3.0, 5.0]
    game = covey.simulate(
        team,
        disk,
        evaders=covey.IterativeOpenLoop(4, 16),
        pursuer=covey.FixedSequence(orders[0]),
        objective=covey.ExpectedSurvival(orders, weights),
        sensing="visible",
    )
    row = int(np.flatnonzero(game.times == game.capture_times[0])[0])
    living = [0, 1, 3]
    rest = covey.Team(
        game.evader_positions[row, living],
        game.evader_headings[row, living],
        team.speeds[living],
        team.turn_rates[living],
    )
    place = covey.PursuerDisk(game.disk_centers[row], 0.0, disk.speed)
    left = covey.ExpectedSurvival([(0, 1, 2), (2, 1, 0)], [1.0, 3.0])
    flown = covey.expected_survival(rest, place, game.evader_turns[row, living], left)
    best = covey.plan(rest, place, objective=left)
    assert flown == pytest.approx(best.value, rel=1e-3)
    all_alike = covey.plan(rest, place, objective=covey.ExpectedSurvival())
    other = covey.expected_survival(rest, place, all_alike.turns, left)
    assert flown > other


def test_a_team_that_expects_another_pursuer_plans_on():
    team, disk = random_game(np.random.default_rng(9), 3)
    game = covey.simulate(
        team,
        disk,
        pursuer=covey.FixedSequence([2, 1, 0]),
        objective=covey.ExpectedSurvival([(0, 1, 2), (1, 0, 2)]),
    )
    assert game.capture_sequence.tolist() == [2, 1, 0]
    assert math.isfinite(game.value)


def test_a_committed_pursuer_makes_small_what_the_game_is_about():
    """Nobody moves, so its first sequence is its last: by hand, as for plans."""
    team = covey.Team([(-0.9, 0.0), (1.0, 0.0), (1.0, 0.1)], [0.0] * 3, 0.0)
    disk = covey.PursuerDisk()
    for pursuer in (covey.CommittedPursuer(), covey.UncommittedPursuer(), covey.FlyingPursuer()):
        last = covey.simulate(team, disk, pursuer=pursuer)
        total = covey.simulate(team, disk, pursuer=pursuer, objective=TOTAL)
        assert last.capture_sequence.tolist() == [0, 1, 2]
        assert total.capture_sequence.tolist() == [1, 2, 0]
        assert total.value < last.capture_times.sum()
        assert total.objective == {"name": "total-survival"}


def test_an_objective_that_does_not_fit_is_refused_before_anybody_flies():
    team, disk = random_game(np.random.default_rng(0), 3)
    asked = []

    def plan(situation):
        asked.append(situation)
        return np.zeros(len(situation.evaders))

    with pytest.raises(covey.InputError, match="sequences of all 3 evaders"):
        covey.simulate(team, disk, evaders=plan, objective=covey.ExpectedSurvival([(0, 1)]))
    assert asked == []


def test_a_plan_that_was_not_flown_is_not_trusted():
    """A strategy that puts its own turns in place of those it was given plans on all the same."""
    generator = np.random.default_rng(2)
    for objective in (covey.LastCapture(), TOTAL):
        team, disk = random_game(generator, 4)
        plan = covey.IterativeOpenLoop(4, 0).start(1)
        gains = []

        def disturbed(situation, plan=plan, gains=gains, objective=objective):
            planned = np.array(plan(situation))
            off = situation.turns if len(gains) else planned
            worth = [
                covey.guaranteed_survival(
                    situation.team, situation.disk, turns, objective=objective
                ).time
                for turns in (planned, off)
            ]
            gains.append(worth[0] - worth[1])
            return np.clip(planned + generator.normal(0.0, 0.5, len(planned)), -math.pi, math.pi)

        covey.simulate(
            team, disk, evaders=disturbed, objective=objective, update_time=0.05, time_limit=2.0
        )
        assert len(gains) > 20
        assert min(gains) > -1e-9  # never worse than what is flown, and mostly better
        assert np.mean(np.array(gains) > 1e-6) > 0.5


def test_a_stopped_game_has_no_value_yet():
    team, disk = random_game(np.random.default_rng(0), 2)
    game = covey.simulate(team, disk, objective=TOTAL, time_limit=0.01)
    assert math.isinf(game.value)
    assert math.isfinite(game.planned_value)


def test_strategies_of_ones_own_are_told_the_objective():
    told = set()

    def team_policy(situation):
        told.add(situation.objective)
        return np.zeros(len(situation.evaders))

    def pursuer_policy(situation):
        told.add(situation.objective)
        return covey.Chase(situation.evaders)

    team, disk = random_game(np.random.default_rng(0), 2)
    covey.simulate(team, disk, evaders=team_policy, pursuer=pursuer_policy, objective=TOTAL)
    assert told == {TOTAL}


def test_a_record_keeps_the_objective(tmp_path):
    team, disk = random_game(np.random.default_rng(0), 2)
    objective = covey.ExpectedSurvival([(0, 1), (1, 0)], [1.0, 2.0], "last")
    game = covey.simulate(team, disk, objective=objective)
    covey.save_game(game, tmp_path / "game.parquet")
    again = covey.load_game(tmp_path / "game.parquet")
    assert again.objective == objective.describe() == game.objective
    assert (again.planned_value, again.value) == (game.planned_value, game.value)
