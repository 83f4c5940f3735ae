"""The value of a tree: against all sequences, and against pursuers that put captures off."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from kernels.contingent import reference_tree, trees
from kernels.contingent.test_branch import GAMES, some_tree


@GAMES
def test_the_value_is_the_least_over_all_sequences(seed):
    team, disk, tree, depth, _ = some_tree(seed)
    least, sequence = trees.value(team, disk, tree, depth)
    assert least == pytest.approx(reference_tree.value(team, disk, tree, depth), rel=1e-11)
    assert trees.branch_times(team, disk, tree, depth, sequence)[-1] == pytest.approx(
        least, rel=1e-13
    )


@GAMES
def test_a_bound_that_nothing_beats_is_returned(seed):
    team, disk, tree, depth, _ = some_tree(seed)
    least, _ = trees.value(team, disk, tree, depth)
    assert trees.value(team, disk, tree, depth, 0.999 * least)[0] == 0.999 * least
    assert trees.value(team, disk, tree, depth, 1.001 * least)[0] == pytest.approx(least)


@GAMES
def test_no_bound_is_beaten_by_rounding(seed):
    team, disk, tree, depth, _ = some_tree(seed)
    least, _ = trees.value(team, disk, tree, depth)
    unsolved = (0,) * len(team)
    for bound in (least * np.random.default_rng(seed).uniform(0.5, 0.999, 300)).tolist():
        assert trees.value(team, disk, tree, depth, bound) == (bound, unsolved)


@pytest.mark.parametrize("seed", range(40))
def test_no_delay_undercuts_what_survives_delays(seed):
    team, disk, tree, depth, _ = some_tree(seed)
    least, _ = trees.value(team, disk, tree, depth)
    target = least
    while not trees.survives(team, disk, tree, depth, target, 1e-4 * least):
        target *= 0.98
        assert target > 0.5 * least
    generator = np.random.default_rng(seed)
    for _ in range(30):
        sequence = generator.permutation(len(team))
        delays = least * generator.uniform(0.0, 0.3, depth) * generator.integers(0, 2, depth)
        ends = reference_tree.times(team, disk, tree, depth, sequence, list(delays))[-1]
        assert ends >= target * (1.0 - 1e-9)


def test_a_delay_that_helps_the_pursuer_is_found():
    """One evader comes nearer until the other, at the pursuer, is captured; then it flees."""
    team = covey.Team([[0.0, 0.0], [2.0, 0.0]], [math.pi / 2, math.pi], 0.8, math.inf)
    disk, tree = covey.PursuerDisk(), np.array([0.0, 0.0, math.pi, 0.9])
    delays = np.linspace(0.0, 3.0, 301)
    ends = [
        reference_tree.times(team, disk, tree, 1, sequence, [delay])[-1]
        for sequence in ([0, 1], [1, 0])
        for delay in delays
    ]
    value, _ = trees.value(team, disk, tree, 1)
    assert value == pytest.approx(min(ends[0], ends[len(delays)]))
    assert min(ends) < 0.95 * value
    assert trees.survives(team, disk, tree, 1, 0.999 * min(ends), 1e-6)
    assert not trees.survives(team, disk, tree, 1, 1.0001 * min(ends), 1e-6)
