"""Every player decides something legal in any game, in any unit of length and time."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from random_games import extent, games

TEAMS = [
    covey.IterativeOpenLoop(starts=1, restarts=1),
    covey.OpenLoop(starts=1),
    covey.ConstantHeading(starts=1, restarts=1),
    covey.KnownSequence(),
    covey.LargestDistance(),
    covey.SmallestDanger(),
    covey.StraightAway(),
    covey.HoldCourse(),
]
PURSUERS = [
    covey.AssuredPursuer(),
    covey.CommittedPursuer(),
    covey.FlyingPursuer(offset=(0.6, 0.8)),
    covey.BestSequence(),
    covey.NearestFirst(),
    covey.RandomSequence(),
    covey.UncommittedPursuer(),
]


@pytest.mark.parametrize("evaders", TEAMS, ids=lambda team: type(team).__name__)
@given(game=games(most=3), pursuer=st.sampled_from(PURSUERS), hidden=st.booleans())
@settings(deadline=None, max_examples=25)
def test_every_team_meets_every_pursuer(evaders, game, pursuer, hidden):
    team, disk, _ = game
    step = 0.1 * (extent(team, disk) or 1.0) / disk.speed
    played = covey.simulate(
        team,
        disk,
        evaders=evaders,
        pursuer=pursuer,
        sensing="hidden" if hidden else "visible",
        update_time=step,
        time_limit=4.0 * step,
    )
    assert np.isfinite(played.evader_turns).all()
    assert np.isfinite(played.evader_positions).all()
    assert np.isfinite(played.pursuer_positions).all()
    if isinstance(evaders, covey.IterativeOpenLoop | covey.OpenLoop):
        slack = 1e-9 * (1.0 + played.guarantee / step) * step
        assert played.survival_time >= played.guarantee - slack
