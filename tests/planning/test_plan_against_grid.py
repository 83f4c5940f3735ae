"""One and two evaders: no plan on a dense grid of turns is better than the one returned."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from kernels import kernel_calls, reference_game
from random_games import random_game

SOLVED = 1e-8
"""Of the survival time, relative: a plan ends where a step promises less than 1e-9."""
MISSED = 1e-3
"""Of the survival time, relative: what the grid may miss where maxima are narrow."""


def best_on_grid(team, disk, points):
    """The best value on a grid over all turns, refined around its best point."""
    n = len(team)
    values = kernel_calls.times_of_sequences(team, disk, reference_game.every_sequence(n))
    center, half = np.zeros(n), math.pi
    best = -math.inf
    while half > 1e-6:
        axes = [
            np.clip(np.linspace(middle - half, middle + half, points), -math.pi, math.pi)
            for middle in center
        ]
        grid = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, n)
        found = np.array([values(turns).min() for turns in grid])
        if found.max() > best:
            best, center = found.max(), grid[found.argmax()]
        half = 0.25 * half if half < math.pi else 4.0 * math.pi / points
        points = 9
    return best


@pytest.mark.parametrize("options", [{}, {"radius": 0.2}, {"capture_radius": 0.05}], ids=str)
@pytest.mark.parametrize("mixed", [False, True])
@pytest.mark.parametrize(("count", "points"), [(1, 2001), (2, 61)])
def test_no_turns_on_the_grid_are_better(count, points, mixed, options):
    generator = np.random.default_rng([count, mixed, *(round(100 * v) for v in options.values())])
    for _ in range(4):
        team, disk = random_game(generator, count, mixed=mixed, **options)
        plan = covey.plan(team, disk)
        best = best_on_grid(team, disk, points)
        assert plan.survival_time >= best * (1.0 - SOLVED)
        assert plan.survival_time <= best * (1.0 + MISSED)
