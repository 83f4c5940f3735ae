"""The yardstick: hand cases, the principle of optimality by brute force, and the bracket."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.bounds import solve_two_evaders
from covey.players import DownhillPursuer

SPEEDS = [(0.25, 0.25), (0.5, 0.7)]
CELLS = 64
KNOWN = 0.02
"""To what the value is known on this grid where the two are close; it halves as cells double."""


@pytest.fixture(scope="module", params=SPEEDS)
def value(request):
    return solve_two_evaders(request.param, cells=CELLS)


def pairs(count, *, close, seed=0):
    """Places of two evaders around a pursuer in the origin."""
    generator = np.random.default_rng(seed)
    places = generator.uniform(-0.5, 0.5, (count, 2, 2))
    if close:
        places[:, 1] = places[:, 0] + generator.uniform(-0.1, 0.1, (count, 2))
    return places


def game(value, places):
    return covey.Team(places, [0.0, 0.0], value.speeds, math.inf), covey.PursuerDisk()


def test_opposite_sides(value):
    """Both flee straight away; the pursuer takes one, then the other, whichever way is shorter."""

    def order(near, v_near, far, v_far):
        time = near / (1.0 - v_near)
        return (time + near + v_near * time + far) / (1.0 - v_far)

    v1, v2 = value.speeds
    expected = min(order(0.5, v1, 1.0, v2), order(1.0, v2, 0.5, v1))
    assert value.at([[0.5, 0.0], [-1.0, 0.0]]) == pytest.approx(expected, rel=1e-9)


def test_a_captured_one_leaves_the_distance_over_the_difference_of_speeds(value):
    assert value.at([[0.0, 0.0], [0.6, 0.8]]) == pytest.approx(1.0 / (1.0 - value.speeds[1]))
    assert value.at([[0.6, 0.8], [0.0, 0.0]]) == pytest.approx(1.0 / (1.0 - value.speeds[0]))


def test_depends_on_shape_and_scale_alone(value):
    places = pairs(20, close=False)
    angle = 0.7
    turned = places @ np.array(
        [[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]]
    )
    assert value.at(turned) == pytest.approx(value.at(places), rel=1e-9)
    assert value.at(places * [1, -1]) == pytest.approx(value.at(places), rel=1e-12)
    assert value.at(3.0 * places) == pytest.approx(3.0 * value.at(places), rel=1e-9)


def test_is_the_value_of_the_game_wherever_it_is_played(value, frame):
    for places in pairs(5, close=False):
        team, disk = frame.game(*game(value, places))
        assert value.of(team, disk) == pytest.approx(frame.time * value.at(places), rel=1e-9)


def test_equal_evaders_can_be_swapped():
    value = solve_two_evaders((0.4, 0.4), cells=32)
    places = pairs(20, close=True)
    # The sweeps visit one side first and end when they change nothing by more than 1e-7.
    assert value.at(places[:, ::-1]) == pytest.approx(value.at(places), rel=1e-4)


@pytest.mark.parametrize("close", [False, True])
def test_bracket_contains_it_and_open_loop_never_exceeds_it(value, close):
    excess = []
    for places in pairs(60, close=close, seed=1):
        team, disk = game(value, places)
        found, true = covey.bracket(team, disk), value.of(team, disk)
        assert found.lower <= true * (1.0 + KNOWN)
        assert true <= found.upper * (1.0 + 1e-9)
        excess.append(found.lower / true - 1.0)
    assert np.maximum(excess, 0.0).mean() < 1e-3


def test_grids_converge():
    values = [solve_two_evaders((0.5, 0.5), cells=cells) for cells in (16, 32, 64)]
    for close in (False, True):
        first, second, third = (value.at(pairs(500, close=close)) for value in values)
        steps = abs(second / first - 1.0).mean(), abs(third / second - 1.0).mean()
        assert steps[1] < 0.6 * steps[0]


def test_principle_of_optimality(value):
    """What a step leads to, by brute force over all headings, is the value less the step.

    Where the two are not close; 36 headings lose 0.4 % of a speed.
    """
    step, angles = 0.1, np.linspace(-math.pi, math.pi, 36, endpoint=False)
    units = np.column_stack([np.cos(angles), np.sin(angles)])
    v1, v2 = value.speeds
    places = pairs(40, close=False, seed=2)
    apart = np.hypot(*(places[:, 1] - places[:, 0]).T) > 0.3
    far = np.hypot(places[..., 0], places[..., 1]).min(axis=1) > 0.3
    for place in places[apart & far][:4]:
        worst = []
        for towards in units:
            first = place[0] + step * (v1 * units - towards)
            second = place[1] + step * (v2 * units - towards)
            both = np.stack(np.broadcast_arrays(first[:, np.newaxis], second), axis=-2)
            worst.append(value.at(both).max())
        assert min(worst) == pytest.approx(value.at(place) - step, abs=0.03 * step)


def test_downhill_pursuer_holds_any_team_to_the_value(value):
    generator = np.random.default_rng(4)
    pursuer = DownhillPursuer(value)

    def roam(situation):
        return generator.uniform(-math.pi, math.pi, len(situation.evaders))

    for places in pairs(3, close=True, seed=3):
        team, disk = game(value, places)
        true = value.of(team, disk)
        for evaders in (covey.IterativeOpenLoop(), covey.OpenLoop(), roam):
            played = covey.simulate(
                team,
                disk,
                evaders=evaders,
                pursuer=pursuer,
                sensing="visible",
                update_time=true / 100,
            )
            assert played.survival_time <= true * (1.0 + KNOWN)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"speeds": (0.5, 1.0)}, r"speeds: expected two numbers in \[0, 1\)"),
        ({"speeds": (-0.1, 0.5)}, "speeds: expected two numbers"),
        ({"speeds": 0.5}, "speeds: expected an array"),
        ({"speeds": (0.5, 0.5), "cells": 8}, "cells: expected a whole number >= 16"),
        ({"speeds": (0.5, 0.5), "tolerance": 0.0}, "tolerance"),
    ],
)
def test_rejects_bad_input(arguments, message):
    with pytest.raises(covey.InputError, match=message):
        solve_two_evaders(**arguments)


@pytest.mark.parametrize(
    ("team", "disk", "message"),
    [
        (covey.Team([[1, 0]], [0], 0.25, math.inf), covey.PursuerDisk(), "expected two evaders"),
        (covey.Team([[1, 0], [0, 1]], [0, 0]), covey.PursuerDisk(), "infinite turn rates"),
        (
            covey.Team([[1, 0], [0, 1]], [0, 0], 0.25, math.inf),
            covey.PursuerDisk(radius=0.1),
            "expected radius 0",
        ),
        (covey.Team([[1, 0], [0, 1]], [0, 0], 0.1, math.inf), covey.PursuerDisk(), "speeds"),
    ],
)
def test_knows_one_kind_of_game_only(team, disk, message):
    value = solve_two_evaders((0.25, 0.25), cells=16)
    with pytest.raises(covey.InputError, match=message):
        value.of(team, disk)
