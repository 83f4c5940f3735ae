"""A hidden pursuer that is flown: it has a place in its disk, and captures tell the team of it."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.simulation import Settings
from covey.simulation.match import Match
from games import fleeing, random_game

PLANNING = covey.IterativeOpenLoop(starts=4)


def flown(team, disk, pursuer, *, evaders=PLANNING):
    settings = Settings("hidden", 0.01, 0, flown=True)
    match = Match(team, disk, evaders, pursuer, settings)
    while not match.over:
        match.step()
    return match.record()


def along(bearing):
    return covey.Fly((math.cos(bearing), math.sin(bearing)))


def at_the_nearest(situation):
    off = situation.team.positions - situation.place
    nearest = off[np.argmin(np.hypot(*off.T))]
    return along(math.atan2(nearest[1], nearest[0]))


def test_one_evader_that_flees_straight_away_by_hand():
    # It is caught at (d - ρ) / (v_p - v), inside an update interval.
    disk = covey.PursuerDisk(capture_radius=0.02)
    game = flown(fleeing(0.5), disk, lambda now: along(0.7))
    assert game.survival_time == pytest.approx(0.48 / 0.75, rel=1e-12)
    assert np.hypot(*game.pursuer_positions[-1]) == pytest.approx(0.64, rel=1e-12)
    assert game.disk_radii[-1] == 0.02
    assert game.disk_centers[-1] == pytest.approx(game.evader_positions[-1, 0])


def test_only_the_pursuer_is_told_its_place():
    def team_plans(situation):
        assert situation.place is None
        return np.zeros(len(situation.evaders))

    team, disk = random_game(np.random.default_rng(3), 2, capture_radius=0.05)
    game = flown(team, disk, at_the_nearest, evaders=team_plans)
    assert game.status is covey.GameStatus.ALL_CAPTURED


def test_whoever_comes_within_reach_is_captured_chased_or_not():
    disk = covey.PursuerDisk(capture_radius=0.05)
    team = covey.Team([[0.3, 0.04], [0.6, 0.0]], [0.0, 0.0], 0.0)
    game = flown(team, disk, lambda now: covey.Fly((1.0, 0.0)))
    assert game.capture_sequence.tolist() == [0, 1]
    assert game.capture_times == pytest.approx([0.3 - 0.03, 0.55], rel=1e-9)


@pytest.mark.parametrize("seed", range(10))
def test_the_guarantee_holds_and_nobody_within_reach_is_left_alive(seed):
    team, disk = random_game(np.random.default_rng(seed), 3, capture_radius=0.04)
    game = flown(team, disk, at_the_nearest)
    assert game.survival_time >= game.guarantee - 1e-9
    # At no row was somebody within reach who had not been captured.
    for row, critical in enumerate(game.critical_sequences[:-1]):
        living = critical[critical >= 0]
        off = game.evader_positions[row, living] - game.pursuer_positions[row]
        assert np.hypot(*off.T).min() >= disk.capture_radius * (1.0 - 1e-9)


def test_what_cannot_be_flown_is_an_error():
    with pytest.raises(covey.InputError, match="capture_radius: expected a number > 0"):
        flown(fleeing(0.5), covey.PursuerDisk(), lambda now: along(0.7))
    with pytest.raises(covey.InputError, match="expected Fly, got Chase"):
        flown(fleeing(0.5), covey.PursuerDisk(capture_radius=0.1), covey.CommittedPursuer())
    with pytest.raises(covey.InputError, match="a speed of at most 1"):
        flown(
            fleeing(0.5),
            covey.PursuerDisk(capture_radius=0.1),
            lambda now: covey.Fly((1.1, 0.0)),
        )
