"""Delays against plans that answer captures: flown as by recursion, none ends too early."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import covey
from kernels.contingent import reference_tree
from random_games import random_game
from soak import answers
from soak.delays import ends


@pytest.mark.parametrize("depth", [0, 1, 2])
def test_plays_with_delays_are_flown_as_by_recursion(depth):
    generator = np.random.default_rng(depth)
    team, disk = random_game(generator, 3, radius=0.1, capture_radius=0.02)
    tree = covey.plan_contingent(team, disk, depth)
    sequences = np.array(list(itertools.permutations(range(3))))
    delays = generator.exponential(0.3, (6, 3)) * [1.0, 1.0, 0.0]
    delays[:, depth:] = 0.0  # the recursion knows delays of answered captures only
    found = ends(tree, sequences, delays)
    for sequence, put_off, end in zip(sequences.tolist(), delays.tolist(), found, strict=True):
        times = reference_tree.times(team, disk, tree.node.turns, depth, sequence, put_off)
        assert end == pytest.approx(times[-1], rel=1e-9)
    assert ends(tree, sequences, np.zeros((6, 3))).min() == pytest.approx(tree.survival_time)


def test_teams_that_answer_captures_keep_their_promises(capsys):
    assert answers.main(["--trees", "2", "--plays", "200", "--minutes", "0.02"]) == 0
    assert "none below what is guaranteed" in capsys.readouterr().out


def test_a_play_that_ends_too_early_is_found(monkeypatch):
    monkeypatch.setattr(answers, "ends", lambda *play: 0.9 * ends(*play))
    with pytest.raises(SystemExit, match="start 0, 3 evaders"):
        answers.main(["--trees", "1", "--plays", "200"])
