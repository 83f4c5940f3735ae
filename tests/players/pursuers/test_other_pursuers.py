"""Pursuers that choose an order once, by greed, or from a place of their own."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from covey.bounds.fixed_sequence import plan_for_sequence
from random_games import random_game

BOTH = pytest.mark.parametrize("sensing", ["hidden", "visible"])
ROUNDING = 1e-9


@BOTH
def test_nearest_first_takes_the_nearest_of_those_that_are_left(sensing):
    """Nobody moves: from the origin to 1, from there to -1 and to -3, and back to 9."""
    team = covey.Team([(9.0, 0.0), (-1.0, 0.0), (1.0, 0.0), (-3.0, 0.0)], np.zeros(4), speeds=0.0)
    disk = covey.PursuerDisk((0.1, 0.0))
    game = covey.simulate(
        team, disk, pursuer=covey.NearestFirst(), sensing=sensing, update_time=0.5
    )
    assert game.capture_sequence.tolist() == [2, 1, 3, 0]
    assert game.capture_times == pytest.approx([0.9, 2.9, 4.9, 16.9])


def test_nearest_first_keeps_its_target_although_another_comes_nearer():
    team = covey.Team([(1.0, 0.0), (1.2, 0.0)], [0.0, math.pi], speeds=[0.5, 0.5], turn_rates=0.0)
    game = covey.simulate(
        team, covey.PursuerDisk(), evaders=covey.HoldCourse(), pursuer=covey.NearestFirst()
    )
    assert game.capture_sequence.tolist() == [0, 1]
    assert (game.pursuer_sequences[game.times < game.capture_times[0], 0] == 0).all()


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_the_best_sequence_is_the_best_of_all(count):
    """Against the fixed-sequence problem of every order."""
    for seed in range(4):
        team, disk = random_game(np.random.default_rng(seed), count, radius=0.1 * (seed % 2))
        values = {
            order: plan_for_sequence(team, disk, order).survival_time
            for order in itertools.permutations(range(count))
        }
        chosen = tuple(covey.BestSequence().sequence_for(team, disk, seed).tolist())
        assert values[chosen] <= min(values.values()) * (1.0 + 1e-9)


@BOTH
@pytest.mark.parametrize(
    "evaders",
    [
        covey.IterativeOpenLoop(starts=2, restarts=1),
        covey.KnownSequence(),
        covey.LargestDistance(),
        covey.SmallestDanger(),
        covey.StraightAway(),
        lambda now: np.sin(1e3 * (now.time + np.arange(len(now.evaders)))),
    ],
)
def test_no_team_that_turns_at_once_outlives_the_best_sequence(evaders, sensing):
    for seed in range(4):
        generator = np.random.default_rng(seed)
        count = 2 + seed % 3
        speeds = generator.choice([0.1, 0.25, 0.5], count)
        places = generator.uniform(-0.5, 0.5, (count, 2))
        team, disk = covey.Team(places, np.zeros(count), speeds, math.inf), covey.PursuerDisk()
        order = covey.BestSequence().sequence_for(team, disk, seed)
        value = plan_for_sequence(team, disk, order).survival_time
        game = covey.simulate(
            team,
            disk,
            evaders=evaders,
            pursuer=covey.BestSequence(),
            sensing=sensing,
            update_time=0.1,
            seed=seed,
        )
        assert game.survival_time <= value * (1.0 + ROUNDING)


@BOTH
@pytest.mark.parametrize("pursuer", [covey.BestSequence(), covey.RandomSequence()])
def test_a_chosen_sequence_is_kept_to(pursuer, sensing):
    for seed in range(3):
        team, disk = random_game(np.random.default_rng(seed), 4)
        order = pursuer.sequence_for(team, disk, seed).tolist()
        compiled, python = (
            covey.simulate(team, disk, pursuer=each, sensing=sensing, update_time=0.05, seed=seed)
            for each in (pursuer, pursuer.start(seed))
        )
        assert compiled.capture_sequence.tolist() == python.capture_sequence.tolist() == order
        assert compiled.survival_time == python.survival_time


def test_random_sequences_come_from_the_seed():
    team, disk = random_game(np.random.default_rng(0), 6)
    draws = [
        tuple(covey.RandomSequence().sequence_for(team, disk, seed).tolist()) for seed in range(50)
    ]
    assert draws[7] == tuple(covey.RandomSequence().sequence_for(team, disk, 7).tolist())
    assert len(set(draws)) > 40


def test_random_sequences_come_as_often_as_they_weigh():
    team, disk = random_game(np.random.default_rng(0), 3)
    pursuer = covey.RandomSequence([(0, 1, 2), (2, 0, 1), (1, 0, 2)], [1.0, 3.0, 0.0])
    draws = [tuple(pursuer.sequence_for(team, disk, seed).tolist()) for seed in range(400)]
    assert set(draws) == {(0, 1, 2), (2, 0, 1)}
    assert draws.count((2, 0, 1)) == pytest.approx(300, abs=45)  # five standard deviations


@BOTH
def test_an_uncommitted_pursuer_is_a_committed_one_without_margin(sensing):
    team, disk = random_game(np.random.default_rng(0), 4)
    uncommitted, free, python = (
        covey.simulate(team, disk, pursuer=each, sensing=sensing, update_time=0.05, time_limit=4.0)
        for each in (
            covey.UncommittedPursuer(),
            covey.CommittedPursuer(0.0),
            covey.UncommittedPursuer().start(0),
        )
    )
    assert np.array_equal(uncommitted.pursuer_positions, free.pursuer_positions)
    assert np.array_equal(uncommitted.pursuer_positions, python.pursuer_positions)


def test_its_old_name_is_an_alias():
    with pytest.warns(DeprecationWarning, match="UncommittedPursuer"):
        assert covey.PatientPursuer is covey.UncommittedPursuer
