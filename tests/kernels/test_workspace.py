"""Scratch is carved from a workspace: all of it fits, and the next call finds the same arrays."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from covey.kernels.arrays import new_workspace
from covey.kernels.maximum.values import minimum_over_sequences
from covey.planning.guarantee import paths_of, pursuit_of
from covey.planning.workspace import LARGEST_KEPT, workspace
from random_games import random_game


@pytest.mark.parametrize("total", [False, True])
@pytest.mark.parametrize("size", range(1, 13))
def test_a_workspace_holds_all_scratch_of_its_size(size, total):
    team, disk = random_game(np.random.default_rng(size), size)
    memory = new_workspace(size, total)
    paths, sequence = paths_of(team, disk, np.zeros(size)), np.empty(size, np.int64)
    for _ in range(2):
        minimum_over_sequences(paths, pursuit_of(disk), total, np.inf, sequence, memory)
        for used, buffer in zip(
            memory.carved, (*memory[3:8], memory.ints, memory.int_rows), strict=True
        ):
            assert 0 < used <= len(buffer)


def test_a_smaller_team_fits_into_the_workspace_of_a_larger_one():
    team, disk = random_game(np.random.default_rng(0), 4)
    turns = np.full(4, 0.3)
    paths, sequence = paths_of(team, disk, turns), np.empty(4, np.int64)
    time = minimum_over_sequences(
        paths, pursuit_of(disk), False, np.inf, sequence, new_workspace(9)
    )
    expected = covey.guaranteed_survival(team, disk, turns)
    assert (time, tuple(sequence.tolist())) == (expected.time, expected.sequence)


def test_a_thread_keeps_the_workspaces_of_small_teams_only():
    assert workspace(5) is workspace(5)
    assert workspace(5) is not workspace(5, total=True)
    large = LARGEST_KEPT + 1
    assert workspace(large) is not workspace(large)
