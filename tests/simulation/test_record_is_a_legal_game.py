"""What the record says happened is a game by the rules, checked without the code that played it."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from random_games import random_game
from simulation import custom_pursuers
from simulation.reference_flight import captures, flown

ROUNDING = 1e-9
"""Of a length or an angle, in games of about unit size."""
SAMPLES = 50
"""Moments between two rows at which somebody might have been touched."""

KINDS = [
    (sensing, radius, reach)
    for sensing in ("hidden", "visible")
    for radius, reach in [(0.0, 0.0), (0.2, 0.0), (0.0, 0.05), (0.2, 0.05)]
]


def games_of(sensing, radius, reach):
    """Games of every kind of player, to their end."""
    players = [
        lambda seed: covey.CommittedPursuer(),
        custom_pursuers.nearest_first,
        custom_pursuers.redrawing,
        custom_pursuers.roaming if sensing == "visible" else custom_pursuers.waiting,
    ]
    teams = [covey.IterativeOpenLoop(starts=2, restarts=2), covey.OpenLoop(starts=2)]
    for seed, (evaders, pursuer) in enumerate(itertools.product(teams, players)):
        generator = np.random.default_rng([seed, round(100 * radius), round(100 * reach)])
        for count, mixed in [(1, False), (3, True), (5, False)]:
            team, disk = random_game(
                generator, count, radius=radius, capture_radius=reach, mixed=mixed
            )
            yield covey.simulate(
                team,
                disk,
                evaders=evaders,
                pursuer=pursuer(seed),
                sensing=sensing,
                update_time=0.07,
                seed=seed,
                time_limit=12.0,
            )


@pytest.fixture(scope="module", params=KINDS, ids="{0[0]}, radius {0[1]}, reach {0[2]}".format)
def played(request):
    return list(games_of(*request.param))


def steps(game):
    """Each row but the last, and the time until the next one."""
    return enumerate(np.diff(game.times).tolist())


def distance(a, b):
    return float(np.hypot(*(np.asarray(a) - b)))


def test_everyone_flies_what_was_announced(played):
    for game in played:
        for row, duration in steps(game):
            places, headings = flown(game, row, [duration])
            for i in range(len(game.team)):
                here, there = game.evader_positions[row : row + 2, i]
                if i in places:
                    assert distance(there, places[i][0]) <= ROUNDING
                    turned_to = game.evader_headings[row + 1, i]
                    assert abs(turned_to - headings[i][0]) <= ROUNDING
                else:
                    assert np.array_equal(here, there)


def test_nobody_is_faster_than_it_can_be(played):
    for game in played:
        durations = np.diff(game.times)[:, None]
        team = game.team
        assert durations.min() >= 0.0
        moved = np.linalg.norm(np.diff(game.evader_positions, axis=0), axis=2)
        assert (moved <= team.speeds * durations + ROUNDING).all()
        slow = np.isfinite(team.turn_rates)
        turned = np.abs(np.diff(game.evader_headings, axis=0))[:, slow]
        assert (turned <= team.turn_rates[slow] * durations + ROUNDING).all()


def test_the_pursuer_is_no_faster_than_it_can_be(played):
    """A visible one that was in a disk shows where as it sets out, so that row isn't compared."""
    for game in played:
        shown = game.sensing == "visible"
        if not shown and game.disk.capture_radius > 0.0:
            continue  # with reach, a hidden pursuer may be anywhere in it after each capture
        first = 1 if shown and game.disk.radius > 0.0 else 0
        moved = np.linalg.norm(np.diff(game.pursuer_positions[first:], axis=0), axis=1)
        assert (moved <= game.disk.speed * np.diff(game.times[first:]) + ROUNDING).all()
        from_center = distance(game.pursuer_positions[first], game.disk.center)
        assert from_center <= game.disk.radius + game.disk.speed * game.times[first] + ROUNDING


def test_each_capture_is_a_row_of_its_own(played):
    """At its exact time, and nobody vanishes otherwise."""
    for game in played:
        found = [(i, game.times[row]) for i, row in captures(game)]
        assert found == list(zip(game.capture_sequence, game.capture_times, strict=True))
        assert len({row for _, row in captures(game)}) == len(found)


def test_who_is_captured_is_within_reach(played):
    for game in played:
        for i, row in captures(game):
            place, reach = game.evader_positions[row, i], game.disk.capture_radius
            if game.sensing == "visible":
                assert distance(place, game.pursuer_positions[row]) <= reach + ROUNDING
            else:
                duration = game.times[row] - game.times[row - 1]
                grown = game.disk_radii[row - 1] + game.disk.speed * duration
                off = distance(place, game.disk_centers[row - 1]) - grown - reach
                assert off <= ROUNDING
                # Taken as soon as the disk reached it, or, by a pursuer that thought better of it,
                # at a decision.
                assert off >= -ROUNDING or duration == 0.0


def test_a_hidden_pursuer_is_a_disk_that_grows_and_collapses(played):
    for game in played:
        if game.sensing == "visible":
            continue
        taken = {row: i for i, row in captures(game)}
        for row, duration in steps(game):
            center, radius = game.disk_centers[row], game.disk_radii[row]
            if row + 1 in taken:
                center = game.evader_positions[row + 1, taken[row + 1]]
                assert game.disk_radii[row + 1] == game.disk.capture_radius
            else:
                grown = radius + game.disk.speed * duration
                assert abs(game.disk_radii[row + 1] - grown) <= ROUNDING
            assert np.array_equal(game.disk_centers[row + 1], center)
        assert np.array_equal(game.disk_centers[0], game.disk.center)
        assert game.disk_radii[0] == game.disk.radius


def test_a_visible_pursuer_is_where_its_disk_is(played):
    for game in played:
        if game.sensing == "hidden":
            continue
        assert np.array_equal(game.disk_centers, game.pursuer_positions)
        assert game.disk_radii[0] == game.disk.radius
        assert (game.disk_radii[1:] == 0.0).all()


def test_a_visible_pursuer_takes_whomever_it_comes_near(played):
    """Between rows, nobody alive is within its reach."""
    shares = np.arange(1, SAMPLES) / SAMPLES
    for game in played:
        reach = game.disk.capture_radius
        if game.sensing == "hidden" or reach == 0.0:
            continue
        first = 1 if game.disk.radius > 0.0 else 0  # before, it may still show where it is
        for row, duration in steps(game):
            if row < first or duration == 0.0:
                continue
            start, end = game.pursuer_positions[row : row + 2]
            pursuer = start + shares[:, None] * (end - start)
            places, _ = flown(game, row, shares * duration)
            for path in places.values():
                nearest = np.linalg.norm(path - pursuer, axis=1).min()
                assert nearest >= reach - ROUNDING


def test_a_hidden_pursuer_is_shown_where_it_captures(played):
    for game in played:
        if game.sensing == "visible" or game.disk.radius > 0.0:
            continue
        for i, row in captures(game):
            off = distance(game.pursuer_positions[row], game.evader_positions[-1, i])
            assert off <= game.disk.capture_radius + ROUNDING


def test_the_last_row_is_the_end(played):
    for game in played:
        if game.status is covey.GameStatus.ALL_CAPTURED:
            assert sorted(game.capture_sequence) == list(range(len(game.team)))
            assert game.survival_time == game.capture_times[-1] == game.times[-1]
            assert game.guarantees[-1] == 0.0
        else:
            assert math.isinf(game.survival_time)
            assert game.times[-1] == pytest.approx(12.0, abs=ROUNDING)
