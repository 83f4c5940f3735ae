"""A pursuer that puts captures off passes over whom it has captured on the way."""

import pytest

import covey
from covey.players import DelayedSequence

TEAM = covey.Team([(0.5, 0.0), (1.0, 0.0)], [0.0, 0.0], 0.0)  # on one line from the pursuer


def test_a_visible_pursuer_takes_the_nearer_evader_on_its_way_to_the_farther():
    disk = covey.PursuerDisk(capture_radius=0.1)
    game = covey.simulate(
        TEAM,
        disk,
        evaders=covey.HoldCourse(),
        pursuer=DelayedSequence((1, 0), (0.0, 0.0)),
        sensing="visible",
        update_time=0.1,
    )
    assert game.capture_sequence.tolist() == [0, 1]
    assert game.capture_times == pytest.approx([0.4, 0.9])
