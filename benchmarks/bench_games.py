"""How long whole games take, kernels compiled, one core."""

from __future__ import annotations

import itertools

import pytest

import covey
from moments import UPDATE_TIME, moments

GAMES = 50


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_whole_game_of_five(benchmark, sensing):
    games = itertools.cycle(itertools.islice(moments(5), GAMES))
    benchmark.group = f"whole game, N = 5, update time {UPDATE_TIME}"
    benchmark.pedantic(
        lambda team, disk: covey.simulate(team, disk, sensing=sensing, update_time=UPDATE_TIME),
        setup=lambda: (next(games).first[:2], {}),
        rounds=GAMES,
        warmup_rounds=3,
    )
