"""The compiled game and the loop in Python are one game, to the last bit.

The strategies that come with the package are compiled as long as `simulate` knows them; given as
plain functions, they are asked one decision at a time.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from random_games import random_game
from simulation.same_games import differences

TEAMS = [covey.OpenLoop(starts=3), covey.IterativeOpenLoop(starts=3, restarts=2)]
MOST = 30
"""Of 36 games end in time, even against a pursuer that dithers."""
PURSUERS = ["1 %", "no margin", "infinite margin", "fixed"]


def pursuer_of(kind, generator, count):
    if kind == "fixed":
        return covey.FixedSequence(generator.permutation(count))
    margins = {"1 %": 0.01, "no margin": 0.0, "infinite margin": math.inf}
    return covey.CommittedPursuer(margin=margins[kind])


def play_both_ways(team, disk, evaders, pursuer, seed, **settings):
    compiled = covey.simulate(team, disk, evaders=evaders, pursuer=pursuer, seed=seed, **settings)
    in_python = covey.simulate(
        team, disk, evaders=evaders.start(seed), pursuer=pursuer.start(seed), seed=seed, **settings
    )
    return compiled, in_python


def random_games(kind, counts, repeats):
    """Teams of every size and kind, with and without a disk and reach."""
    disks = [(0.0, 0.0), (0.2, 0.0), (0.1, 0.04)]
    for count, (radius, reach), seed in itertools.product(counts, disks, range(repeats)):
        generator = np.random.default_rng([count, round(100 * reach), seed])
        team, disk = random_game(
            generator, count, radius=radius, capture_radius=reach, mixed=reach > 0.0
        )
        yield team, disk, pursuer_of(kind, generator, count), seed


def every_combination(test):
    for mark in (
        pytest.mark.parametrize("evaders", TEAMS, ids=lambda team: type(team).__name__),
        pytest.mark.parametrize("kind", PURSUERS),
        pytest.mark.parametrize("sensing", ["hidden", "visible"]),
    ):
        test = mark(test)
    return test


@every_combination
def test_games_to_the_end(evaders, kind, sensing):
    ended = 0
    for team, disk, pursuer, seed in random_games(kind, counts=range(1, 7), repeats=2):
        compiled, in_python = play_both_ways(
            team, disk, evaders, pursuer, seed, sensing=sensing, update_time=0.08, time_limit=20.0
        )
        if compiled.status is covey.GameStatus.ALL_CAPTURED:
            assert differences(compiled, in_python) == []
            ended += 1
    assert ended >= MOST


@every_combination
@pytest.mark.parametrize("time_limit", [0.3, 0.8])
def test_games_that_are_stopped(evaders, kind, sensing, time_limit):
    for team, disk, pursuer, seed in random_games(kind, counts=(2, 4, 5), repeats=1):
        compiled, in_python = play_both_ways(
            team,
            disk,
            evaders,
            pursuer,
            seed,
            sensing=sensing,
            update_time=0.05,
            time_limit=time_limit,
        )
        assert differences(compiled, in_python) == []


def test_with_more_than_eight_restarts():
    team, disk = random_game(np.random.default_rng(4), 6)
    evaders = covey.IterativeOpenLoop(starts=3, restarts=13)
    games = play_both_ways(team, disk, evaders, covey.CommittedPursuer(), 4, update_time=0.2)
    assert differences(*games) == []
