"""Algorithm 1 against a plain implementation with a general root finder, and what it must obey."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given

import covey
from kernels import reference_game
from random_games import games, random_game, random_turns, time_rounding

ENCLOSED = 1e-12
"""Of the reference's times, relative: N roots, each enclosed to 1e-15 and amplified by the next."""


@pytest.mark.parametrize("mixed", [False, True])
@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.2, 0.0), (0.0, 0.05), (0.2, 0.05)])
def test_agrees_with_a_plain_implementation(mixed, radius, reach):
    generator = np.random.default_rng([mixed, round(100 * radius), round(100 * reach)])
    for count in (1, 2, 3, 5):
        team, disk = random_game(generator, count, radius=radius, capture_radius=reach, mixed=mixed)
        turns, sequence = random_turns(generator, count), generator.permutation(count)
        wanted = reference_game.sequence_times(team, disk, turns, sequence)
        found = covey.capture_times(team, disk, turns, sequence)
        rounding = time_rounding(team, disk, wanted[-1])
        assert found == pytest.approx(wanted, rel=ENCLOSED, abs=rounding)


@given(games(most=3, fastest=0.7))
def test_agrees_with_a_plain_implementation_at_every_scale(game):
    team, disk, turns = game
    sequence = list(range(len(team)))
    wanted = reference_game.sequence_times(team, disk, turns, sequence)
    found = covey.capture_times(team, disk, turns, sequence)
    assert found == pytest.approx(wanted, rel=ENCLOSED, abs=time_rounding(team, disk, wanted[-1]))


@given(games(most=4))
def test_times_do_not_decrease(game):
    team, disk, turns = game
    times = covey.capture_times(team, disk, turns, range(len(team)))
    assert (np.diff(times, prepend=0.0) >= 0.0).all()


@given(games(most=3, fastest=0.7, disks=False))
def test_leaving_an_evader_out_never_costs_time(game):
    """With ρ = 0 a pursuer that need not pass by an evader is at the others no later."""
    team, disk, turns = game
    whole = covey.capture_times(team, disk, turns, range(len(team)))
    rounding = time_rounding(team, disk, whole[-1])
    for left_out in range(len(team) - 1):
        rest = [i for i in range(len(team)) if i != left_out]
        smaller = covey.Team(
            team.positions[rest], team.headings[rest], team.speeds[rest], team.turn_rates[rest]
        )
        times = covey.capture_times(smaller, disk, turns[rest], range(len(rest)))
        assert times[-1] <= whole[-1] + rounding


def test_places_of_capture_are_reached_at_full_speed():
    """Between two captures the pursuer flies a straight line at v_p, unless it has to wait."""
    generator = np.random.default_rng(4)
    team, disk = random_game(generator, 5, mixed=True)
    turns, sequence = random_turns(generator, 5), [3, 1, 4, 0, 2]
    times = covey.capture_times(team, disk, turns, sequence)
    places = [disk.center] + [
        reference_game.place(team, turns, i, t) for i, t in zip(sequence, times, strict=True)
    ]
    legs = [np.hypot(*(b - a)) for a, b in itertools.pairwise(places)]
    assert legs == pytest.approx(np.diff(times, prepend=0.0), rel=ENCLOSED, abs=0.0)
