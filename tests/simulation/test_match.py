"""A game that is stepped from outside is the game that `simulate` plays."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from covey.simulation import Settings
from covey.simulation.match import Match
from random_games import random_game
from soak import custom_pursuers
from soak.same_games import differences

PURSUERS = [covey.CommittedPursuer(), covey.FlyingPursuer(), custom_pursuers.Unseen()]


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("pursuer", PURSUERS, ids=lambda pursuer: type(pursuer).__name__)
def test_step_by_step(pursuer, sensing):
    evaders = covey.IterativeOpenLoop(starts=2, restarts=1)
    team, disk = random_game(np.random.default_rng(5), 3, radius=0.1, capture_radius=0.03)
    match = Match(team, disk, evaders, pursuer, Settings(sensing, 0.05, 1, 12.0))
    rows = []
    while not match.over:
        # What has happened until now stays as it is.
        rows.append(match.record())
        match.step()
    game = match.record()
    played = covey.simulate(
        team,
        disk,
        evaders=evaders,
        pursuer=pursuer,
        sensing=sensing,
        update_time=0.05,
        seed=1,
        time_limit=12.0,
    )
    assert not differences(game, played)
    for row, early in enumerate(rows):
        assert len(early.times) == row + 1
        assert np.array_equal(early.evader_positions, game.evader_positions[: row + 1])
        assert np.array_equal(early.guarantees, game.guarantees[: row + 1])
