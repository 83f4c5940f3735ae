"""Between the rows of a record everyone flies on, exactly."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.views.games.snapshot import snapshot_at, trajectories, until
from views.flown_games import (
    FIRST_CAPTURE,
    RADIUS,
    RATE,
    SECOND_CAPTURE,
    game_by_hand,
    simulated,
    turning_evader,
)

ROUNDING = 1e-14
"""Of positions in a square of side 1."""


@pytest.mark.parametrize("time", [0.0, 0.3, 0.5, 0.79])
def test_before_the_first_capture(time):
    snapshot = snapshot_at(game_by_hand(), time)
    assert snapshot.alive.tolist() == [True, True]
    assert snapshot.team.positions[0] == pytest.approx([0.6 + 0.25 * time, 0.0], abs=ROUNDING)
    assert snapshot.team.positions[1] == pytest.approx(turning_evader(time), abs=ROUNDING)
    assert snapshot.team.headings.tolist() == pytest.approx([0.0, RATE * time], abs=ROUNDING)
    assert snapshot.turns.tolist() == pytest.approx([0.0, RATE * (1.0 - time)], abs=ROUNDING)
    assert snapshot.disk.radius == pytest.approx(time, abs=ROUNDING)
    assert snapshot.disk.center.tolist() == [0.0, 0.0]
    assert snapshot.pursuer == pytest.approx([time, 0.0], abs=ROUNDING)
    assert snapshot.pursuer_heading == 0.0
    assert snapshot.guaranteed == pytest.approx(SECOND_CAPTURE)
    assert snapshot.sequence.tolist() == [0, 1]


def test_at_a_capture_the_disk_collapses():
    before = snapshot_at(game_by_hand(), math.nextafter(FIRST_CAPTURE, 0.0))
    assert before.alive.all()
    assert before.disk.radius == pytest.approx(FIRST_CAPTURE)
    snapshot = snapshot_at(game_by_hand(), FIRST_CAPTURE)
    assert snapshot.alive.tolist() == [False, True]
    assert snapshot.disk.radius == 0.0
    assert snapshot.disk.center.tolist() == [0.8, 0.0]
    x, y = turning_evader(SECOND_CAPTURE) - snapshot.disk.center
    assert snapshot.pursuer_heading == pytest.approx(math.atan2(y, x))


def test_whoever_is_captured_stays():
    snapshot = snapshot_at(game_by_hand(), 1.5)
    assert snapshot.team.positions[0].tolist() == [0.8, 0.0]
    assert snapshot.team.positions[1] == pytest.approx(turning_evader(1.5), abs=ROUNDING)
    assert snapshot_at(game_by_hand(), SECOND_CAPTURE).alive.tolist() == [False, False]


def test_trajectories_are_arcs_between_rows_that_are_far_apart():
    flown = trajectories(game_by_hand())
    turning = flown.evaders[flown.times < 1.0, 1]
    assert len(turning) > 100
    radii = np.hypot(turning[:, 0], turning[:, 1] - (1.0 + RADIUS))
    assert radii == pytest.approx(np.full(len(turning), RADIUS), abs=ROUNDING)
    assert flown.evaders[-1, 1] == pytest.approx(turning_evader(SECOND_CAPTURE), abs=ROUNDING)
    assert (flown.evaders[flown.times >= FIRST_CAPTURE, 0] == [0.8, 0.0]).all()


def test_a_trajectory_ends_at_the_snapshot():
    snapshot = snapshot_at(game_by_hand(), 0.5)
    past = until(trajectories(game_by_hand()), snapshot)
    assert past.times[-1] == 0.5
    assert (np.diff(past.times) > 0.0).all()
    assert (past.evaders[-1] == snapshot.team.positions).all()
    assert (past.pursuer[-1] == snapshot.pursuer).all()


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_flying_on_from_a_row_leads_to_the_next_one(sensing):
    game = simulated(sensing)
    rows = np.flatnonzero(np.diff(game.times) > 0.0)
    assert len(rows) > 5
    for row in rows:
        just_before = snapshot_at(game, math.nextafter(game.times[row + 1], 0.0))
        assert just_before.team.positions == pytest.approx(
            game.evader_positions[row + 1], abs=1e-13
        )
        assert just_before.pursuer == pytest.approx(game.pursuer_positions[row + 1], abs=1e-13)


def test_the_disk_never_loses_the_pursuer():
    game = simulated("hidden")
    for time in np.linspace(0.0, game.survival_time, 100):
        snapshot = snapshot_at(game, time)
        away = np.hypot(*(snapshot.pursuer - snapshot.disk.center))
        assert away <= snapshot.disk.radius + 1e-12


def test_a_turn_without_limit_is_made_at_once():
    team = covey.Team([[0.3, 0.1], [-0.4, 0.2]], [2.0, 0.0], 0.25, math.inf)
    game = covey.simulate(team, covey.PursuerDisk(), update_time=0.5)
    snapshot = snapshot_at(game, 0.1)
    assert np.hypot(*(snapshot.team.positions - team.positions).T) == pytest.approx([0.025] * 2)
    assert snapshot.turns.tolist() == [0.0, 0.0]
