"""The minimum without a table of all sets: the table's values, and bounds that are bounds."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest

import covey
from covey.kernels.arrays import FINISH, SOLVED, STAGES_GIVEN, new_workspace
from covey.kernels.capture.sequence import capture_times
from covey.kernels.maximum.values import minimum_over_sequences
from covey.kernels.minimum.large.scratch import LOWER
from covey.planning.border import about_center, paths_of, pursuit_of
from random_games import random_game, random_turns


@functools.cache
def walking(size):
    """A workspace whose minimum keeps a table up to three evaders only."""
    return new_workspace(size, fewest_walking=4, largest_table=3)


def bounds_without_table(team, disk, turns, *, stages=12, warm=False, stop=0):
    """The lower bound, the upper bound, and the sequence that attains the upper bound."""
    memory = walking(22)
    if not warm:
        memory.walks.ints[SOLVED] = 0
    memory.walks.ints[STAGES_GIVEN], memory.stop[0] = stages, stop
    sequence = np.empty(len(team), np.int64)
    moved, about = about_center(team, disk)
    upper = minimum_over_sequences(
        moved.as_rows(), turns, pursuit_of(about), False, math.inf, sequence, memory
    )
    return memory.walks.floats[LOWER], upper, sequence


def games(count, number, seed=0):
    """Teams of `count`, of all kinds: disks, capture radii, mixed vehicles, simple motion."""
    for game in range(number):
        generator = np.random.default_rng([seed, count, game])
        team, disk = random_game(
            generator,
            count,
            radius=(0.0, 0.1, 0.3)[game % 3],
            capture_radius=(0.0, 0.02)[game % 2],
            mixed=game % 4 > 1,
        )
        yield team, disk, random_turns(generator, count) * (0.2, 1.0)[game % 5 > 2]


@pytest.mark.parametrize("count", range(4, 14))
def test_without_a_table_the_minimum_is_the_same(count):
    for team, disk, turns in games(count, 24):
        expected = covey.guaranteed_survival(team, disk, turns)
        lower, upper, sequence = bounds_without_table(team, disk, turns)
        assert lower == upper == pytest.approx(expected.time, rel=1e-12)
        assert covey.capture_times(team, disk, turns, sequence)[-1] == upper


def test_what_the_call_before_has_learnt_changes_no_minimum():
    generator = np.random.default_rng(1)
    for team, disk, turns in games(12, 12, seed=1):
        bounds_without_table(team, disk, turns + generator.uniform(-0.1, 0.1, 12))
        lower, upper, _ = bounds_without_table(team, disk, turns, warm=True)
        expected = covey.guaranteed_survival(team, disk, turns).time
        assert lower == upper == pytest.approx(expected, rel=1e-12)


def test_a_search_that_ends_early_has_bounds_on_both_sides():
    open_ones = 0
    for team, disk, turns in games(21, 4, seed=2):
        lower, upper, sequence = bounds_without_table(team, disk, turns, stop=FINISH)
        expected = covey.guaranteed_survival(team, disk, turns)
        assert expected.exact
        assert 0.0 < lower <= expected.time * (1.0 + 1e-12)
        assert expected.time <= upper * (1.0 + 1e-12)
        assert covey.capture_times(team, disk, turns, sequence)[-1] == upper
        open_ones += lower < upper
    assert open_ones > 1


def ring(count):
    angles = np.arange(count) * 2.0 * math.pi / count
    return np.column_stack([np.cos(angles), np.sin(angles)]), angles


DEGENERATE = {
    "circle": ring,
    "line": lambda count: (np.column_stack([np.arange(count) * 0.1, np.ones(count)]), 0.3),
    "clusters": lambda count: (
        np.repeat(ring(3)[0], count // 3, axis=0) + 1e-3 * ring(count)[0],
        ring(count)[1],
    ),
    "coincident": lambda count: (np.ones((count, 2)), ring(count)[1]),
    "all one": lambda count: (np.ones((count, 2)), 0.3),
}


@pytest.mark.parametrize("kind", DEGENERATE)
@pytest.mark.parametrize("fastest", [0.25, 0.9])
def test_degenerate_teams_have_the_same_minimum(kind, fastest):
    positions, headings = DEGENERATE[kind](12)
    speeds = np.full(12, 0.25)
    speeds[5] = fastest
    team, disk = covey.Team(positions, headings + np.zeros(12), speeds), covey.PursuerDisk()
    turns = np.linspace(-0.5, 0.5, 12)
    lower, upper, _ = bounds_without_table(team, disk, turns)
    expected = covey.guaranteed_survival(team, disk, turns).time
    assert lower == upper == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("kind", DEGENERATE)
def test_large_degenerate_teams_have_a_guarantee_within_seconds(kind):
    positions, headings = DEGENERATE[kind](30)
    team, disk = covey.Team(positions, headings + np.zeros(30)), covey.PursuerDisk()
    found = covey.guaranteed_survival(team, disk, np.zeros(30), time_limit=1.0)
    assert 0.0 < found.time <= found.upper
    assert covey.capture_times(team, disk, np.zeros(30), found.sequence)[-1] == found.upper


def test_no_sequence_refutes_a_guarantee_of_thirty():
    generator = np.random.default_rng(3)
    team, disk = random_game(generator, 30)
    turns = 0.3 * random_turns(generator, 30)
    found = covey.guaranteed_survival(team, disk, turns)
    assert found.exact
    moved, about = about_center(team, disk)
    paths, pursuit, times = paths_of(moved, about, turns), pursuit_of(about), np.empty(30)
    worst, least = np.array(found.sequence), found.time * (1.0 - 1e-12)
    for sequence in generator.permuted(np.tile(worst, (80_000, 1)), axis=1):
        assert capture_times(paths, pursuit, sequence, times) >= least
    for a, b, c in np.sort(generator.integers(0, 31, (20_000, 3)), axis=1):
        moved_stretch = np.concatenate([worst[:a], worst[b:c], worst[a:b], worst[c:]])
        assert capture_times(paths, pursuit, moved_stretch, times) >= least


def test_a_sum_for_more_than_twenty_is_refused():
    team, disk = random_game(np.random.default_rng(5), 21)
    message = "^team: expected at most 20 evaders for a sum of survival times, got 21; .*split"
    with pytest.raises(covey.InputError, match=message):
        covey.guaranteed_survival(team, disk, np.zeros(21), objective=covey.TotalSurvival())
    with pytest.raises(covey.InputError, match=message):
        covey.plan(team, disk, objective=covey.TotalSurvival(), time_limit=1.0)
