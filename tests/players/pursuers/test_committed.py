"""Pursuers keep to a sequence: a given one, or the best, until another is clearly better."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from random_games import random_game

BOTH = pytest.mark.parametrize("sensing", ["hidden", "visible"])


def changes_of_mind(game):
    """In how many rows the sequence isn't the one before, less whom it took."""
    changes = 0
    for row in range(len(game.times) - 2):
        before, after = (
            sequence[sequence >= 0].tolist() for sequence in game.pursuer_sequences[row : row + 2]
        )
        changes += [i for i in before if i in after] != after
    return changes


@pytest.mark.parametrize("order", list(itertools.permutations(range(3))))
@BOTH
def test_a_fixed_sequence_is_followed(order, sensing):
    """Without reach, nobody is taken on the way."""
    for seed in range(5):
        team, disk = random_game(np.random.default_rng(seed), 3, radius=0.1 * (seed % 2))
        game = covey.simulate(
            team, disk, pursuer=covey.FixedSequence(order), sensing=sensing, update_time=0.05
        )
        assert tuple(game.capture_sequence) == order
        assert changes_of_mind(game) == 0


@BOTH
def test_the_first_choice_is_the_quickest_sequence(sensing):
    for seed in range(10):
        team, disk = random_game(np.random.default_rng(seed), 5, mixed=seed % 2 == 1)
        plan = covey.plan(team, disk, seed=seed, starts=covey.IterativeOpenLoop().starts)
        game = covey.simulate(team, disk, sensing=sensing, seed=seed, time_limit=0.01)
        # Several may be equally quick, to the last bit.
        times = covey.capture_times(team, disk, plan.turns, game.pursuer_sequences[0])
        assert times[-1] == plan.survival_time


@BOTH
def test_an_infinite_margin_never_lets_it_change_its_mind(sensing):
    for seed in range(20):
        team, disk = random_game(
            np.random.default_rng(seed), 5, capture_radius=0.03 * (seed % 2), mixed=seed % 3 == 0
        )
        game = covey.simulate(
            team,
            disk,
            pursuer=covey.CommittedPursuer(margin=math.inf),
            sensing=sensing,
            update_time=0.05,
            seed=seed,
        )
        assert changes_of_mind(game) == 0


def test_without_a_margin_it_dithers():
    """The team makes several sequences equally good, and whichever is followed is worse next time.

    In this game a pursuer that changes its mind for nothing takes half as long again for four
    evaders as one that asks for a gain of one in a hundred.
    """
    team, disk = random_game(np.random.default_rng(11), 4)

    def play(margin):
        return covey.simulate(
            team,
            disk,
            pursuer=covey.CommittedPursuer(margin),
            sensing="visible",
        )

    committed, fickle = play(0.01), play(0.0)
    assert fickle.survival_time > 1.5 * committed.survival_time
    assert changes_of_mind(fickle) > 20 > 5 > changes_of_mind(committed)


@BOTH
def test_it_changes_its_mind_where_that_pays_more_than_the_margin(sensing):
    """Once the team has turned away from it, the far evader can wait."""
    team = covey.Team([(1.0, 0.0), (-1.0, 0.0)], np.zeros(2), speeds=0.5, turn_rates=math.inf)
    headings = {0.0: [math.pi, math.pi], 0.25: [0.0, 0.0]}

    def evaders(situation):
        goal = np.array(headings[0.0 if situation.time < 0.25 else 0.25])[list(situation.evaders)]
        return covey.turns_to(situation.team, goal)

    game = covey.simulate(team, covey.PursuerDisk(), evaders=evaders, sensing=sensing)
    stubborn = covey.simulate(
        team,
        covey.PursuerDisk(),
        evaders=evaders,
        pursuer=covey.CommittedPursuer(math.inf),
        sensing=sensing,
    )
    assert (changes_of_mind(game), changes_of_mind(stubborn)) == (1, 0)
    assert game.survival_time < stubborn.survival_time
