"""A batch is its games, side by side: what Gymnasium makes of single views, step by step."""

from __future__ import annotations

import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv

import covey
from covey.envs import pursuit_v0
from envs.scripted_players import towards_nearest

COUNT, STEPS = 4, 150
VIEWS = {
    "pursuer": (pursuit_v0.PursuerVectorEnv, pursuit_v0.PursuerEnv),
    "team": (pursuit_v0.TeamVectorEnv, pursuit_v0.TeamEnv),
}
OPPONENTS = [
    ("pursuer", {}),
    ("pursuer", {"evaders": covey.OpenLoop(starts=3)}),
    ("team", {}),
    ("pursuer", {"evaders": covey.IterativeOpenLoop(starts=2, restarts=2, replan_time=0.12)}),
    ("team", {"pursuer": covey.FixedSequence([1, 0, 2])}),
    ("team", {"pursuer": covey.UncommittedPursuer()}),
    ("team", {"pursuer": covey.BestSequence()}),
    ("team", {"pursuer": covey.RandomSequence()}),
]


def assert_same(one, other):
    """Compare what batches return: arrays, dictionaries of them, arrays of arrays or None."""
    if isinstance(one, dict):
        assert one.keys() == other.keys()
        for key in one:
            assert_same(one[key], other[key])
    elif one.dtype == object:
        for a, b in zip(one, other, strict=True):
            assert (a is None) == (b is None)
            if a is not None:
                assert_same(a, b)
    else:
        assert one.dtype == other.dtype
        np.testing.assert_allclose(one, other, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
@pytest.mark.parametrize(("side", "opponent"), OPPONENTS)
def test_a_batch_is_its_games(side, opponent, sensing):
    game = {"sensing": sensing, "time_limit": 2.5, "capture_radius": 0.05, "disk_radius": 0.05}
    batch_of, single = VIEWS[side]
    batch = batch_of(COUNT, **game, **opponent)
    singles = SyncVectorEnv(
        [lambda: single(**game, **opponent)] * COUNT, autoreset_mode=AutoresetMode.SAME_STEP
    )
    generator = np.random.default_rng(0)
    ours, theirs = batch.reset(seed=3), singles.reset(seed=3)
    ended = 0
    for _ in range(STEPS):
        for a, b in zip(ours, theirs, strict=True):
            assert_same(a, b)
        actions = generator.uniform(-1.0, 1.0, (COUNT, 3))
        if side == "pursuer":
            actions = towards_nearest(ours[0], 3) + generator.normal(0.0, 0.01, (COUNT, 2))
        ours, theirs = batch.step(actions), singles.step(actions)
        ended += int((ours[2] | ours[3]).sum())
    assert ended >= COUNT


def test_the_number_of_games_changes_none_of_them():
    few, many = pursuit_v0.PursuerVectorEnv(2), pursuit_v0.PursuerVectorEnv(5)
    seen, more = few.reset(seed=11)[0], many.reset(seed=11)[0]
    for _ in range(80):
        np.testing.assert_array_equal(seen, more[:2])
        actions = towards_nearest(more, 3)
        seen, more = few.step(actions[:2])[0], many.step(actions)[0]


def test_a_seed_for_each_game():
    games = pursuit_v0.TeamVectorEnv(3)
    seen, _ = games.reset(seed=[7, 9, 7])
    np.testing.assert_array_equal(seen[0], seen[2])
    assert not np.array_equal(seen[0], seen[1])
