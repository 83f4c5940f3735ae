"""The yardstick as a study: what it reports can be played again, and depends on the seed alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.scenarios.strategies import EVADERS
from covey.studies.analysis.yardstick import default_evaders, measure

SPEEDS = (0.5, 0.7)


def hold_course(situation):
    """The worst of all strategies, nearly."""
    return np.zeros(len(situation.evaders))


@pytest.fixture(scope="module")
def measured():
    evaders = {"open loop": covey.OpenLoop(), "hold": hold_course}
    return measure(SPEEDS, pairs=3, cells=64, seed=2, evaders=evaders)


def test_scores_every_strategy_from_every_start(measured):
    cases = [(score.pairs, score.pair, score.evaders) for score in measured.rows]
    assert cases == [
        (kind, pair, name)
        for kind in ("random", "close")
        for pair in range(3)
        for name in ("open loop", "hold")
    ]


def test_survival_stays_below_the_value_and_the_value_in_its_bracket(measured):
    for score in measured.rows:
        assert score.survival_time <= score.value * 1.02  # the grid is coarse
        assert score.lower <= score.value * 1.02
        assert score.value <= score.upper * (1.0 + 1e-9)
        assert score.lower <= score.survival_time * (1.0 + 1e-9) or score.evaders == "hold"


def test_the_least_survival_time_is_no_more_than_against_the_committed_pursuer(measured):
    for score in measured.rows:
        team = covey.Team(
            [[score.x_1, score.y_1], [score.x_2, score.y_2]], [0.0, 0.0], SPEEDS, math.inf
        )
        strategy = hold_course if score.evaders == "hold" else covey.OpenLoop()
        game = covey.simulate(
            team,
            covey.PursuerDisk(),
            evaders=strategy,
            sensing="visible",
            update_time=score.value / 200,
            seed=2,
        )
        assert score.survival_time <= game.survival_time
        if score.pursuer == "committed":
            assert score.survival_time == game.survival_time


def test_close_pairs_are_close_and_the_value_settles(measured):
    for score in measured.rows:
        if score.pairs == "close":
            apart = math.dist((score.x_1, score.y_1), (score.x_2, score.y_2))
            assert apart <= 0.2 * math.hypot(score.x_1, score.y_1)
    assert [change.cells for change in measured.changes] == [32, 64, 32, 64]
    assert all(change.mean <= change.most < 0.1 for change in measured.changes)


def test_plays_all_that_come_with_covey_and_need_no_parameter():
    assert set(default_evaders()) == set(EVADERS)


def test_needs_a_pair():
    with pytest.raises(covey.InputError, match="pairs: expected a whole number >= 1"):
        measure(SPEEDS, pairs=0)
