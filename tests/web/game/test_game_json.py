"""What a page is told of the captures to expect."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from covey.web.game.game_json import frame

ORIGIN = (3.0, -2.0)
STARTS = [[0.3, 0.1], [-0.2, 0.35], [0.1, -0.4], [-0.4, -0.15]]


@pytest.fixture(scope="module")
def announced():
    """A hidden pursuer captures in the order that the plan expects, and the plan is kept."""
    positions = np.add(STARTS, ORIGIN)
    headings = np.arctan2(*np.transpose(STARTS)[::-1])
    team = covey.Team(positions, headings, [0.2, 0.3, 0.25, 0.22], [1.5, 2.0, 1.0, np.inf])
    disk = covey.PursuerDisk(ORIGIN, 0.05, 1.1, 0.02)
    plan = covey.plan(team, disk, seed=0)
    return covey.simulate(
        team,
        disk,
        evaders=covey.OpenLoop(),
        pursuer=covey.FixedSequence(plan.critical_sequences[0]),
        sensing="hidden",
        update_time=0.05,
    )


def test_expected_captures_come_true_if_everybody_does_as_expected(announced):
    game = announced
    for row in range(len(game.times)):
        told = frame(game, row)
        captured = len(told["captured"])
        assert told["sequence"] == game.capture_sequence[captured:].tolist()
        assert told["expected"] == pytest.approx(game.capture_times[captured:], abs=1e-9)
    assert told["expected"] == told["sequence"] == []
    assert len(game.times) > 20


def test_the_last_expected_capture_is_what_is_guaranteed(announced):
    for row in range(len(announced.times) - 1):
        told = frame(announced, row)
        # A guarantee counts from the moment, an expected capture from the start.
        assert told["expected"][-1] == pytest.approx(told["time"] + told["guarantee"], abs=1e-9)


def test_captured_are_those_whose_time_has_come(announced):
    for row, now in enumerate(announced.times.tolist()):
        told = frame(announced, row)
        assert [i for i, _ in told["captured"]] + told["sequence"] == [
            *announced.capture_sequence.tolist()
        ]
        assert all(time <= now for _, time in told["captured"])


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_expected_captures_are_algorithm_1_from_that_moment_on(sensing):
    """Against a pursuer that does otherwise, with a team that plans again."""
    team = covey.Team(np.add(STARTS, ORIGIN), [0.0, 1.0, 2.0, 3.0], 0.25, 1.5)
    disk = covey.PursuerDisk(ORIGIN, 0.0, 1.0, 0.02)
    pursuer = covey.FixedSequence([3, 1, 0, 2]) if sensing == "hidden" else covey.CommittedPursuer()
    game = covey.simulate(team, disk, pursuer=pursuer, sensing=sensing, update_time=0.05)
    for row in range(0, len(game.times) - 1, 7):
        told = frame(game, row)
        order = told["sequence"]
        positions, headings = game.evader_positions[row][order], game.evader_headings[row][order]
        now = covey.Team(positions, headings, 0.25, 1.5)
        around = covey.PursuerDisk(game.disk_centers[row], game.disk_radii[row], 1.0, 0.02)
        times = covey.capture_times(now, around, game.evader_turns[row][order], range(len(order)))
        assert told["expected"] == pytest.approx(game.times[row] + times, rel=1e-12)
