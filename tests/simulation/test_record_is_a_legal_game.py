"""What the record says happened is a game by the rules, checked without the code that played it."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import covey
from random_games import random_game
from soak import custom_pursuers, legal_game

ROUNDING = 1e-13
"""Radians, or relative to the extent of a game."""
TIME_LIMIT = 12.0

KINDS = [
    (sensing, radius, reach)
    for sensing in ("hidden", "visible")
    for radius, reach in [(0.0, 0.0), (0.2, 0.0), (0.0, 0.05), (0.2, 0.05)]
]


def games_of(sensing, radius, reach):
    """Games of every kind of player, to their end."""
    players = [
        lambda seed: covey.CommittedPursuer(),
        custom_pursuers.nearest_first,
        custom_pursuers.redrawing,
        custom_pursuers.roaming if sensing == "visible" else custom_pursuers.waiting,
    ]
    teams = [covey.IterativeOpenLoop(starts=2, restarts=2), covey.OpenLoop(starts=2)]
    for seed, (evaders, pursuer) in enumerate(itertools.product(teams, players)):
        generator = np.random.default_rng([seed, round(100 * radius), round(100 * reach)])
        for count, mixed in [(1, False), (3, True), (5, False)]:
            team, disk = random_game(
                generator, count, radius=radius, capture_radius=reach, mixed=mixed
            )
            yield covey.simulate(
                team,
                disk,
                evaders=evaders,
                pursuer=pursuer(seed),
                sensing=sensing,
                update_time=0.07,
                seed=seed,
                time_limit=TIME_LIMIT,
            )


@pytest.fixture(scope="module", params=KINDS, ids="{0[0]}, radius {0[1]}, reach {0[2]}".format)
def found(request):
    """The errors of each game."""
    return [legal_game.errors(game, TIME_LIMIT) for game in games_of(*request.param)]


@pytest.mark.parametrize("check", legal_game.CHECKS)
def test_a_game_goes_by_the_rules(found, check):
    assert max(errors[check] for errors in found) <= ROUNDING
