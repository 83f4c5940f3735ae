"""Every record of a legal game passes the checks of a loaded record."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from covey.simulation.consistency import require_consistent
from players.test_any_game import PURSUERS, TEAMS
from random_games import extent, games, random_game
from simulation.played_records import played
from soak import custom_pursuers

OBJECTIVES = [covey.LastCapture(), covey.TotalSurvival(), covey.ExpectedSurvival()]


@pytest.mark.parametrize("evaders", TEAMS, ids=lambda team: type(team).__name__)
@given(
    game=games(most=4),
    pursuer=st.sampled_from(PURSUERS),
    sensing=st.sampled_from(["hidden", "visible"]),
    objective=st.sampled_from(OBJECTIVES),
    update=st.sampled_from([0.1, 3.0]),
)
@settings(max_examples=25)
def test_every_legal_record_is_consistent(evaders, game, pursuer, sensing, objective, update):
    team, disk, _ = game
    step = update * (extent(team, disk) or 1.0) / disk.speed
    record = covey.simulate(
        team,
        disk,
        evaders=evaders,
        pursuer=pursuer,
        sensing=sensing,
        objective=objective,
        update_time=step,
        time_limit=4.0 * step,
    )
    require_consistent(record)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("pursuer", ["redrawing", "farthest_first", "roaming", "waiting"])
def test_records_of_ones_own_pursuers_are_consistent(sensing, pursuer):
    if (sensing, pursuer) == ("hidden", "roaming"):
        return  # a disk can't be steered
    strategy = getattr(custom_pursuers, pursuer)(0)
    for reach in (0.0, 0.05):
        record = played(7, 4, sensing, 9.0, strategy, radius=0.1, capture_radius=reach)
        require_consistent(record)


def test_a_game_in_a_frame_far_away_is_consistent():
    team, disk = random_game(np.random.default_rng(8), 4)
    far = covey.Team(team.positions + 1e4, team.headings + 100.0, team.speeds, team.turn_rates)
    there = covey.PursuerDisk(disk.center + 1e4, 0.1, disk.speed, 0.01)
    for sensing in ("hidden", "visible"):
        require_consistent(covey.simulate(far, there, sensing=sensing))
