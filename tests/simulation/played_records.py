"""Records of games on both sides of each rule, and their bytes."""

from __future__ import annotations

from io import BytesIO

import numpy as np

import covey
from covey.simulation.storage import write_game
from random_games import random_game


def written(game):
    buffer = BytesIO()
    write_game(game, buffer)
    return buffer.getvalue()


def played(seed, count, sensing="hidden", time_limit=None, pursuer=None, **disk):
    team, disk = random_game(np.random.default_rng(seed), count, mixed=True, **disk)
    return covey.simulate(
        team,
        disk,
        pursuer=pursuer or covey.CommittedPursuer(),
        sensing=sensing,
        update_time=0.2,
        time_limit=time_limit,
    )


RECORDS = [
    played(1, 3),
    played(2, 2, "visible", radius=0.2),
    played(3, 3, "visible", capture_radius=0.05),
    played(4, 2, radius=0.2, capture_radius=0.05),
    played(5, 3, time_limit=0.6),
    played(6, 1, "visible", pursuer=covey.FlyingPursuer(offset=(0.6, 0.8)), capture_radius=0.1),
]
