"""How long plans and games take, kernels compiled, one core. Run with `make bench`."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import covey
from covey.kernels.replanning import replan
from covey.kernels.search import search_scratch
from covey.planning.guarantee import pursuit_of
from covey.planning.open_loop import (
    DEFAULT_TOLERANCE,
    MOST_STEPS,
    columns_of,
    start_noise,
)

GAMES = 50
SIZES = (2, 3, 5, 8, 10, 12)
DISK = covey.PursuerDisk()


def teams(size):
    """Teams as in section V of the paper: uniform in the unit square, headings away."""
    generator = np.random.default_rng(size)
    for _ in range(GAMES):
        positions = generator.uniform(-0.5, 0.5, (size, 2))
        yield covey.Team(positions, np.arctan2(positions[:, 1], positions[:, 0]))


@pytest.mark.parametrize("size", SIZES)
def test_plan_from_one_start(benchmark, size):
    games = itertools.cycle(teams(size))
    benchmark.group = "cold plan, one start"
    benchmark.pedantic(
        lambda team: covey.plan(team, DISK, starts=1),
        setup=lambda: ((next(games),), {}),
        rounds=4 * GAMES,
        warmup_rounds=GAMES,
    )


@pytest.mark.parametrize("size", SIZES)
def test_warm_plan(benchmark, size):
    """`covey.plan` from the plan of a moment ago, as a caller in Python replans."""
    planned = itertools.cycle([(t, covey.plan(t, DISK, starts=1)) for t in teams(size)])

    def moment_later():
        team, plan = next(planned)
        later = covey.PursuerDisk(radius=0.01)
        return (team, later), {"starts": 1, "warm_start": plan}

    benchmark.group = "warm plan"
    benchmark.pedantic(covey.plan, setup=moment_later, rounds=4 * GAMES, warmup_rounds=GAMES)


@pytest.mark.parametrize("size", SIZES)
def test_warm_replan_in_a_game(benchmark, size):
    """The kernel that a compiled game calls at every update, called from Python."""
    pursuit, noise = pursuit_of(covey.PursuerDisk(radius=0.01)), start_noise(0, 0, size)
    scratch = search_scratch(size)
    planned = itertools.cycle([(t, covey.plan(t, DISK, starts=1)) for t in teams(size)])

    def moment_later():
        team, plan = next(planned)
        arguments = (team.as_rows(), size, pursuit, noise, 0, DEFAULT_TOLERANCE, MOST_STEPS)
        return (*arguments, plan.turns.copy(), columns_of(plan), scratch), {}

    benchmark.group = "warm replan in a game"
    benchmark.pedantic(replan, setup=moment_later, rounds=4 * GAMES, warmup_rounds=GAMES)


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_whole_game_of_five(benchmark, sensing):
    games = itertools.cycle(teams(5))
    benchmark.group = "whole game, N = 5, update time 0.01"
    benchmark.pedantic(
        lambda team: covey.simulate(team, DISK, sensing=sensing),
        setup=lambda: ((next(games),), {}),
        rounds=GAMES,
        warmup_rounds=3,
    )
