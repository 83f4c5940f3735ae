"""Who takes part in a soak."""

from __future__ import annotations

import numpy as np

import covey
from random_games import random_game
from soak import players


def test_every_strategy_that_comes_with_covey_takes_part():
    team, disk = random_game(np.random.default_rng(0), 2)
    setting = players.Setting(team, disk, "visible", 1.0, 0.1)
    generator, kinds = np.random.default_rng(0), [players.downhill]
    for table in ("COMPILED", "INTERPRETED"):
        kinds += [*getattr(players, f"{table}_TEAMS"), *getattr(players, f"{table}_PURSUERS")]
    drawn = {type(kind(generator, setting).strategy) for kind in kinds}
    known = {getattr(covey.players, name) for name in covey.players.__all__}
    strategies = {each for each in known if hasattr(each, "start")}
    assert strategies <= drawn
    assert len(strategies) > 15
