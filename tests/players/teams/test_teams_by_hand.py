"""Each team does, where that can be worked out by hand, what its reference says it does."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import covey
from covey.bounds.fixed_sequence import plan_for_sequence
from frames import Frame
from kernels.reference_game import gap
from random_games import random_game

FOUND_TO = 3e-3
"""Radians: the searches over single turns end at 0.002."""
ROUNDING = 1e-9
DISK = covey.PursuerDisk()


def agile(positions, headings=0.0, speeds=0.25):
    """A team that turns at once."""
    headings = np.broadcast_to(headings, len(positions))
    return covey.Team(positions, headings, speeds, math.inf)


def simulated(frame, team, disk, update_time=0.01, **settings):
    """The game in a frame."""
    team, disk = frame.game(team, disk)
    return covey.simulate(team, disk, update_time=update_time * frame.time, **settings)


def first_headings(frame, team, disk, evaders, **settings):
    """The goal headings of the first plan, as the frame at home has them."""
    limit = 1e-3 * frame.time
    game = simulated(frame, team, disk, evaders=evaders, time_limit=limit, **settings)
    return game.evader_headings[0] + game.evader_turns[0] - frame.angle


def off(angles, others):
    """How far directions are from others."""
    return np.abs(np.angle(np.exp(1j * (np.asarray(angles) - np.asarray(others)))))


def test_holding_course_is_not_to_turn():
    team, disk = random_game(np.random.default_rng(1), 4)
    game = covey.simulate(team, disk, evaders=covey.HoldCourse(), sensing="visible")
    assert (game.evader_turns == 0.0).all()
    assert np.array_equal(game.evader_headings[-1], team.headings)


@pytest.mark.parametrize(
    "evaders",
    [
        covey.StraightAway(),
        covey.ConstantHeading(starts=2),
        covey.KnownSequence(),
        covey.LargestDistance(),
        covey.SmallestDanger(),
    ],
    ids=lambda evaders: type(evaders).__name__,
)
@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_alone_all_of_them_flee_straight_from_the_disk(evaders, sensing):
    """A single evader is caught at (d - r - ρ) / (v_p - v)."""
    disk = covey.PursuerDisk((0.3, -0.2), 0.1, 2.0, 0.05)
    team = agile([(0.3 + 0.6, -0.2 + 0.8)], headings=-2.0, speeds=0.5)
    game = covey.simulate(team, disk, evaders=evaders, sensing=sensing, update_time=0.05)
    assert game.survival_time == pytest.approx((1.0 - 0.1 - 0.05) / 1.5, abs=1e-5)


def test_straight_away_is_away_from_the_last_capture(frame):
    team, evaders = agile([(0.3, 0.0), (0.0, 1.0)], headings=[0.0, math.pi]), covey.StraightAway()
    headings = first_headings(frame, team, DISK, evaders)
    assert off(headings, [0.0, math.pi / 2]).max() < 1e-12
    game = simulated(frame, team, DISK, evaders=evaders, pursuer=covey.FixedSequence([0, 1]))
    place = game.evader_positions[-1, 0]  # (0.4, 0), at t = 0.4
    away = frame.points([0.0, 1.1]) - place
    assert place == pytest.approx(frame.points([0.4, 0.0]))
    assert off(game.evader_headings[-1, 1], math.atan2(away[1], away[0])) < 1e-12


def test_at_the_centre_all_headings_lead_away(frame):
    team = covey.Team([(0.0, 0.0), (0.5, 0.0)], [1.0, 0.0])
    headings = first_headings(frame, team, DISK, covey.StraightAway())
    assert headings == pytest.approx([1.0, 0.0])


@pytest.mark.parametrize("count", [1, 2, 4])
def test_constant_heading_is_iterative_open_loop_in_the_earlier_papers_game(count):
    """No turn limit, and a pursuer that is seen."""
    for seed in range(3):
        generator = np.random.default_rng(seed)
        team = agile(generator.uniform(-0.5, 0.5, (count, 2)))
        settings = {"sensing": "visible", "seed": seed, "update_time": 0.1}
        earlier = covey.ConstantHeading(starts=4, restarts=2)
        game = covey.simulate(team, DISK, evaders=earlier, **settings)
        iterative = covey.IterativeOpenLoop(starts=4, restarts=2)
        same = covey.simulate(team, DISK, evaders=iterative, **settings)
        assert game.survival_time == same.survival_time
        assert np.array_equal(game.evader_positions, same.evader_positions)


def test_constant_heading_forgets_the_disk_and_that_turns_take_time():
    """It heads where an agile team would that knew the pursuer to be at the centre."""
    team, disk = random_game(np.random.default_rng(3), 3, radius=0.2)
    flown = first_headings(Frame(), team, disk, covey.ConstantHeading(), seed=5)
    point = covey.PursuerDisk(disk.center)
    simplified = covey.plan(agile(team.positions, team.headings), point, seed=5)
    assert off(flown, simplified.goal_headings).max() < ROUNDING
    assert off(flown, covey.plan(team, disk, seed=5).goal_headings).max() > 0.1


def test_known_sequence_on_a_line(frame):
    """Captured at 2 and at 10: the first lures the pursuer away from the second."""
    team = agile([(1.0, 0.0), (-1.0, 0.0)], headings=1.0, speeds=0.5)
    evaders = covey.KnownSequence([0, 1])
    assert off(first_headings(frame, team, DISK, evaders), [0.0, math.pi]).max() < 1e-6
    for sensing in ("hidden", "visible"):
        settings = {"pursuer": covey.FixedSequence([0, 1]), "sensing": sensing, "update_time": 0.1}
        game = simulated(frame, team, DISK, evaders=evaders, **settings)
        assert game.capture_times / frame.time == pytest.approx([2.0, 10.0], abs=1e-6)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_known_sequence_lives_for_the_fixed_sequence_value_if_it_is_right(sensing):
    for seed in range(4):
        team, disk = random_game(np.random.default_rng(seed), 2 + seed % 3, radius=0.1)
        order = tuple(np.random.default_rng(seed).permutation(len(team)).tolist())
        settings = {
            "pursuer": covey.FixedSequence(order),
            "sensing": sensing,
            "update_time": 0.1,
        }
        value = plan_for_sequence(team, disk, order).survival_time
        game = covey.simulate(team, disk, evaders=covey.KnownSequence(order), **settings)
        assert game.survival_time >= value - 1e-6
        # A team that has announced its whole flight can't live longer.
        for announced in (covey.OpenLoop(starts=2), covey.HoldCourse()):
            other = covey.simulate(team, disk, evaders=announced, **settings)
            assert other.survival_time <= value + 1e-6


def test_known_sequence_expects_the_best_one_if_it_is_told_none():
    for seed in range(3):
        team, disk = random_game(np.random.default_rng(seed), 4)
        told, untold = (
            covey.simulate(team, disk, evaders=evaders, pursuer=covey.BestSequence(), seed=seed)
            for evaders in (
                covey.KnownSequence(covey.BestSequence().sequence_for(team, disk, 0)),
                covey.KnownSequence(),
            )
        )
        assert told.survival_time == untold.survival_time


def test_largest_distance_to_a_pursuer_that_flies_away(frame):
    """It makes for evader 0, which it meets at (0.4, 0). Evader 1 flees from that place.

    Its least distance is the present one, whatever it does, unless it flies after the pursuer.
    """
    team = agile([(0.3, 0.0), (0.0, 0.5)], headings=[0.0, 2.0])
    headings = first_headings(frame, team, DISK, covey.LargestDistance())
    assert off(headings, [0.0, math.atan2(0.5, -0.4)]).max() < FOUND_TO


def test_largest_distance_where_it_only_grows_is_the_latest_capture_after_the_first(frame):
    """The pursuer meets evader 0 at (0.4, 0), at 0.4. From there it would fly to evader 1.

    A pursuit that began there at time 0 would end while evader 1 turns, whatever its turn.
    """
    team = covey.Team([(0.3, 0.0), (-0.2, 0.3)], [0.0, 1.35], 0.25, [math.inf, 1.2])
    headings = first_headings(frame, team, DISK, covey.LargestDistance())

    def capture(turn):
        pursuit = (np.array([0.4, 0.0]), 0.0, 0.4, 1.0)
        return brentq(lambda time: gap(team, [0.0, turn], 1, *pursuit, time), 0.4, 5.0)

    best = max(map(capture, np.linspace(-math.pi, math.pi, 201)))
    assert capture(headings[1] - 1.35) == pytest.approx(best, abs=1e-4)


def test_largest_distance_to_a_pursuer_that_comes_by(frame):
    """The pursuer would come nearest somewhere on its way to (0.4, 0); every heading was tried."""
    team = agile([(0.3, 0.0), (0.33, 0.45)], headings=[0.0, -1.0])
    heading = first_headings(frame, team, DISK, covey.LargestDistance())[1]

    def least_distance(heading):
        times = np.linspace(0.0, 0.4, 17)[:, None]
        course = np.array([math.cos(heading), math.sin(heading)])
        gaps = team.positions[1] + 0.25 * times * course - times * [1.0, 0.0]
        return np.hypot(*gaps.T).min()

    best = max(map(least_distance, np.linspace(-math.pi, math.pi, 10_000)))
    assert least_distance(heading) == pytest.approx(best, abs=1e-5)
    assert best < least_distance(heading) + 1e-5 < math.hypot(0.33, 0.45)


def test_each_for_itself_gets_behind_its_neighbour(frame):
    """Side by side, both race away from the disk instead of apart, to leave the other in front."""
    disk = covey.PursuerDisk(radius=0.5)
    places = [(0.6, 0.1), (0.6, -0.1)]
    headings = first_headings(frame, agile(places), disk, covey.SmallestDanger())
    assert np.abs(headings).max() < 0.5
    # Both do the same; with a finer count of the disk, no heading has a smaller share.
    assert headings[0] == pytest.approx(-headings[1], abs=0.15)
    time = (math.hypot(0.6, 0.1) - 0.5) / (1.0 - 0.25 * 0.6 / math.hypot(0.6, 0.1))
    radius = 0.5 + time

    def share(heading):
        grid = np.linspace(-radius, radius, 401)
        x, y = np.meshgrid(grid, grid)
        inside = np.hypot(x, y) <= radius
        own = np.add(places[0], 0.25 * time * np.array([math.cos(heading), math.sin(heading)]))
        other = np.add(places[1], [0.25 * time, 0.0])
        nearer = np.hypot(x - own[0], y - own[1]) < np.hypot(x - other[0], y - other[1])
        return (nearer & inside).sum() / inside.sum()

    best = min(map(share, np.linspace(-math.pi, math.pi, 181)))
    assert share(headings[0]) <= best + 1.0 / 256


@pytest.mark.parametrize("evaders", [covey.StraightAway(), covey.IterativeOpenLoop(starts=1)])
def test_a_team_may_turn_beyond_the_largest_heading_that_it_may_begin_with(evaders):
    team = covey.Team([(0.3, 0.1), (-0.2, 0.4)], [1e9, 1e9], 0.25, 1.0)
    game = covey.simulate(team, covey.PursuerDisk(), evaders=evaders, update_time=0.1)
    assert game.evader_headings.max() > 1e9 + 0.1
