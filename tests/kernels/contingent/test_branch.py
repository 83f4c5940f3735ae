"""Branches of trees: their times against a plain recursion, their derivatives by differences."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from kernels.contingent import reference_tree, trees
from random_games import random_game

STEP = 1e-6
SLOPE_ERROR = 1e-7
"""Of a central difference, relative to the largest slope."""

GAMES = pytest.mark.parametrize("seed", range(12))


def some_tree(seed):
    """A game of one to five evaders, of all kinds, with a tree and a sequence."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(1, 6))
    team, disk = random_game(
        generator,
        count,
        radius=generator.choice([0.0, 0.1]),
        capture_radius=generator.choice([0.0, 0.03]),
        mixed=True,
    )
    depth = int(generator.integers(0, count))
    tree = reference_tree.random_tree(generator, team, depth)
    return team, disk, tree, depth, generator.permutation(count)


@GAMES
def test_times_of_a_branch_are_those_of_smaller_and_smaller_games(seed):
    team, disk, tree, depth, sequence = some_tree(seed)
    expected = reference_tree.times(team, disk, tree, depth, sequence)
    assert trees.branch_times(team, disk, tree, depth, sequence) == pytest.approx(
        expected, rel=1e-11
    )


@GAMES
def test_without_an_answer_a_branch_is_algorithm_1(seed):
    team, disk, tree, _, sequence = some_tree(seed)
    turns = tree[: len(team)]
    times = trees.branch_times(team, disk, turns, 0, sequence)
    assert times == pytest.approx(covey.capture_times(team, disk, turns, sequence), rel=1e-14)


@GAMES
def test_derivatives_of_a_branch(seed):
    team, disk, tree, depth, sequence = some_tree(seed)

    def last(turns):
        return trees.branch_times(team, disk, turns, depth, sequence)[-1]

    def slopes(turns):
        return trees.derivatives(team, disk, turns, depth, sequence)[0]

    moves = STEP * np.eye(len(tree))
    gradient, hessian = trees.derivatives(team, disk, tree, depth, sequence)
    by_differences = [(last(tree + m) - last(tree - m)) / (2.0 * STEP) for m in moves]
    error = SLOPE_ERROR * (1.0 + np.abs(hessian).max())
    assert gradient == pytest.approx(by_differences, abs=error)
    by_differences = [(slopes(tree + m) - slopes(tree - m)) / (2.0 * STEP) for m in moves]
    assert hessian == pytest.approx(np.array(by_differences), abs=100.0 * error)
