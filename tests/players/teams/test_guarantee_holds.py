"""No pursuer captures a team sooner than its plan guarantees, and the guarantee never falls."""

from __future__ import annotations

import math
import zlib

import numpy as np
import pytest

import covey
from random_games import random_game
from soak import custom_pursuers

ROUNDING = 1e-9
"""Of a time, in games of about unit size: what a capture may come too soon by."""
LONGEST = 10.0
GAMES, GAMES_IF_COMPILED = 30, 100

PURSUERS = {
    "committed": lambda seed: covey.CommittedPursuer(),
    "changes its mind for nothing": lambda seed: covey.CommittedPursuer(margin=0.0),
    "never changes its mind": lambda seed: covey.CommittedPursuer(margin=math.inf),
    "in numerical order": custom_pursuers.in_numerical_order,
    "new random order every time": custom_pursuers.redrawing,
    "nearest first": custom_pursuers.nearest_first,
    "farthest first": custom_pursuers.farthest_first,
    "waits": custom_pursuers.waiting,
    "roams": custom_pursuers.roaming,
    "random sequence": lambda seed: covey.RandomSequence(),
    "best sequence": lambda seed: covey.BestSequence(),
    "greedy": lambda seed: covey.NearestFirst(),
    "flies in the disk": lambda seed: covey.FlyingPursuer(offset=(0.8, 0.6)),
    "roams unseen": custom_pursuers.Unseen,
}
TEAMS = (
    covey.OpenLoop(starts=2),
    covey.IterativeOpenLoop(starts=2, restarts=2),
    covey.IterativeOpenLoop(starts=2, restarts=0, replan_time=0.25),
)
CASES = [
    (team, sensing, name)
    for team in TEAMS
    for sensing in ("hidden", "visible")
    for name in PURSUERS
    if (sensing, name) != ("hidden", "roams")  # a disk can't be steered
]


def any_game(generator):
    """One to five evaders, alike or not, from a point or a disk, with and without reach."""
    return random_game(
        generator,
        int(generator.integers(1, 6)),
        radius=generator.choice([0.0, 0.2]),
        capture_radius=generator.choice([0.0, 0.02, 0.1]),
        mixed=generator.random() < 0.5,
    )


@pytest.mark.parametrize(
    ("evaders", "sensing", "name"),
    CASES,
    ids=[
        f"{type(team).__name__} {getattr(team, 'replan_time', '')}-{sensing}-{name}"
        for team, sensing, name in CASES
    ],
)
def test_no_pursuer_beats_the_guarantee(evaders, sensing, name):
    case = zlib.crc32(f"{evaders}{sensing}{name}".encode())
    pursuer, ended = PURSUERS[name], 0
    compiled = isinstance(pursuer(0), covey.CommittedPursuer)
    for seed in range(GAMES_IF_COMPILED if compiled else GAMES):
        team, disk = any_game(np.random.default_rng([case, seed]))
        game = covey.simulate(
            team,
            disk,
            evaders=evaders,
            pursuer=pursuer(seed),
            sensing=sensing,
            update_time=0.1,
            seed=seed,
            time_limit=LONGEST,
        )
        lived_longer = game.survival_time - game.guarantee
        assert lived_longer >= -ROUNDING, f"seed {seed}"
        guaranteed_until = game.times + game.guarantees
        largest_fall = -np.diff(guaranteed_until).min()
        assert largest_fall <= ROUNDING, f"seed {seed}"
        ended += game.status is covey.GameStatus.ALL_CAPTURED
    assert ended > 0, "no game was played to its end"
