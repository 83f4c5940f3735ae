"""A hidden pursuer that really is in the disk: what it does is legal, what it gets is real."""

from __future__ import annotations

import math
from itertools import chain, repeat

import numpy as np
import pytest

import covey
from random_games import fleeing, random_game
from soak import custom_pursuers
from soak.reference_flight import captures

ROUNDING = 1e-9
REACH = 0.03


PLAYERS = [custom_pursuers.Unseen(), covey.FlyingPursuer(), covey.FlyingPursuer(0.1, (0.6, -0.8))]


def along(bearing):
    return covey.Fly((math.cos(bearing), math.sin(bearing)))


def distance(a, b):
    return np.hypot(*np.moveaxis(np.asarray(a) - b, -1, 0))


@pytest.fixture(scope="module", params=PLAYERS, ids=["unseen", "committed", "at the edge"])
def played(request):
    games = []
    for seed in range(8):
        team, disk = random_game(
            np.random.default_rng(seed),
            1 + seed % 5,
            radius=0.2 * (seed % 3),
            capture_radius=REACH,
            mixed=seed % 2 == 1,
        )
        evaders = covey.IterativeOpenLoop(starts=2, restarts=1)
        games.append(
            covey.simulate(
                team,
                disk,
                evaders=evaders,
                pursuer=request.param,
                update_time=0.07,
                seed=seed,
                time_limit=15.0,
            )
        )
    return games


def test_it_is_where_the_team_must_think_it_could_be(played):
    for game in played:
        off = distance(game.pursuer_positions, game.disk_centers)
        assert (off <= game.disk_radii + ROUNDING).all()


def test_it_flies_no_faster_than_it_can(played):
    for game in played:
        flown = distance(game.pursuer_positions[1:], game.pursuer_positions[:-1])
        assert (flown <= np.diff(game.times) * game.disk.speed + ROUNDING).all()


def test_it_captures_whom_it_comes_within_reach_of_and_nobody_else(played):
    count = 0
    for game in played:
        for i, row in captures(game):
            off = distance(game.evader_positions[row, i], game.pursuer_positions[row])
            assert off <= REACH + ROUNDING
            count += 1
        # Between the rows: whoever is still alive at a row is out of reach there.
        for row in range(1, len(game.times)):
            alive = game.critical_sequences[row][game.critical_sequences[row] >= 0]
            off = distance(game.evader_positions[row, alive], game.pursuer_positions[row])
            assert (off >= REACH - ROUNDING).all()
    assert count > 5


def test_a_capture_gives_it_away_to_within_its_reach(played):
    for game in played:
        for i, row in captures(game):
            assert game.disk_radii[row] == REACH
            assert np.array_equal(game.disk_centers[row], game.evader_positions[-1, i])


def test_the_guarantee_holds_against_it(played):
    for game in played:
        assert game.survival_time >= game.guarantee - ROUNDING


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_it_starts_where_it_says(sensing):
    disk = covey.PursuerDisk((1.0, 2.0), 0.5)
    team = covey.Team([(3.0, 2.0)], [0.0], turn_rates=0.0)
    game = covey.simulate(
        team, disk, pursuer=covey.FlyingPursuer(offset=(-1.0, 0.0)), sensing=sensing
    )
    assert game.pursuer_positions[0] == pytest.approx([0.5, 2.0])
    assert game.survival_time == pytest.approx(2.5 / 0.75)  # of a disk only: 1.5 / 0.75
    assert game.guarantee == pytest.approx(1.5 / 0.75)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_a_straight_chase_by_hand(sensing):
    # It is over after (d - ρ) / (v_p - v), inside an update interval.
    disk, steered = (
        covey.PursuerDisk(capture_radius=0.02),
        custom_pursuers.Steered(lambda now: along(0.7)),
    )
    game = covey.simulate(fleeing(0.5), disk, pursuer=steered, sensing=sensing)
    assert game.survival_time == pytest.approx(0.48 / 0.75, rel=1e-12)
    assert np.hypot(*game.pursuer_positions[-1]) == pytest.approx(0.64, rel=1e-12)
    if sensing == "hidden":
        assert game.disk_radii[-1] == 0.02
        assert game.disk_centers[-1] == pytest.approx(game.evader_positions[-1, 0])


def test_whoever_comes_within_reach_is_captured_chased_or_not():
    disk = covey.PursuerDisk(capture_radius=0.05)
    team = covey.Team([[0.3, 0.04], [0.6, 0.0]], [0.0, 0.0], 0.0)
    for decision in (along(0.0), covey.Chase((1,)), covey.Chase((1, 0))):
        decisions = chain([decision], repeat(along(0.0)))
        steered = custom_pursuers.Steered(lambda now, decisions=decisions: next(decisions))
        game = covey.simulate(team, disk, pursuer=steered)
        assert game.capture_sequence.tolist() == [0, 1]
        assert game.capture_times == pytest.approx([0.3 - 0.03, 0.55], rel=1e-9)


def test_a_velocity_that_it_cannot_fly_is_an_error():
    steered = custom_pursuers.Steered(lambda now: covey.Fly((1.1, 0.0)))
    with pytest.raises(covey.InputError, match="a speed of at most 1"):
        covey.simulate(fleeing(0.5), covey.PursuerDisk(), pursuer=steered)


def test_far_from_the_origin_the_edge_of_the_disk_is_still_in_it():
    disk = covey.PursuerDisk((1e6, -1e6), 1e-3)
    team = covey.Team([(1e6 + 1.0, -1e6)], [0.0])
    for angle in range(20):
        offset = (math.cos(angle), math.sin(angle))
        covey.simulate(team, disk, pursuer=covey.FlyingPursuer(offset=offset), time_limit=0.01)


def test_the_team_is_not_told_its_place():
    seen = []

    def team_sees(situation):
        seen.append(situation.place)
        return situation.turns

    class Told(custom_pursuers.Unseen):
        def start(self, seed):
            def decide(situation):
                assert distance(situation.place, situation.disk.center) <= situation.disk.radius
                assert situation.pursuer.radius == 0.0
                return covey.Fly()

            return decide

    team = covey.Team([(1.0, 0.0)], [0.0])
    disk = covey.PursuerDisk(radius=0.1)
    covey.simulate(team, disk, evaders=team_sees, pursuer=Told(), time_limit=0.1)
    assert seen
    assert all(place is None for place in seen)


@pytest.mark.parametrize("place", [(0.2, 0.0), (math.nan, 0.0), (0.0,)])
def test_a_place_outside_the_disk_is_refused(place):
    class Elsewhere(custom_pursuers.Unseen):
        def place(self, disk):
            return place

    team = covey.Team([(1.0, 0.0)], [0.0])
    with pytest.raises(covey.InputError, match="place returned by the pursuer's strategy"):
        covey.simulate(team, covey.PursuerDisk(radius=0.1), pursuer=Elsewhere())


@pytest.mark.parametrize("offset", [(1.0, 0.1), (math.nan, 0.0), 0.5])
def test_an_offset_out_of_the_disk_is_refused(offset):
    with pytest.raises(covey.InputError, match=r"FlyingPursuer\.offset: expected"):
        covey.FlyingPursuer(offset=offset)
