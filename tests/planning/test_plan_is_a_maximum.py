"""Nothing near a plan is better: not one turn changed, nor all of them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import nnls

import covey
from kernels import kernel_calls
from planning.continued_ascents import allowed, ascent, assert_cannot_be_continued
from random_games import random_game, random_turns

STATIONARY = 1e-3
"""Time units per radian: to climb a slope of that, with a curvature of 1, gains half its square."""
CHANGES = (1e-4, 1e-3, 1e-2)
"""Radians."""


def neighbours(turns, generator):
    """Turns with one changed, and with all changed."""
    n = len(turns)
    for size in CHANGES:
        for i in range(n):
            for side in (-1.0, 1.0):
                yield turns + side * size * np.eye(n)[i]
        for _ in range(60):
            yield turns + generator.uniform(-size, size, n)
            yield turns + generator.choice([-size, size], n)


@pytest.mark.parametrize(
    "options", [{}, {"radius": 0.2}, {"capture_radius": 0.03}, {"mixed": True}], ids=str
)
@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 6])
def test_no_neighbour_is_better(count, options):
    generator = np.random.default_rng([count, len(str(options))])
    for _ in range(5):
        team, disk = random_game(generator, count, **options)
        plan = covey.plan(team, disk, starts=8)
        assert plan.status is covey.PlanStatus.CONVERGED
        for turns in neighbours(plan.turns, generator):
            inside = np.clip(turns, -math.pi, math.pi)
            assert kernel_calls.least(team, disk, inside)[0] <= allowed(plan)


@pytest.mark.parametrize(
    "options", [{"radius": 0.1}, {"radius": 0.4, "capture_radius": 0.1}], ids=str
)
@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_an_ascent_that_has_converged_cannot_be_continued(count, options):
    """Nor where a sequence of evaders that are all caught turning has neither slope nor bend."""
    generator = np.random.default_rng([count, len(options)])
    for _ in range(600):
        team, disk = random_game(generator, count, **options)
        plan = ascent(team, disk, random_turns(generator, count))
        if plan.status is covey.PlanStatus.CONVERGED:
            assert_cannot_be_continued(team, disk, plan)


@pytest.mark.parametrize("seed", [3837, 9495])
def test_nor_in_two_games_where_it_once_could(seed):
    generator = np.random.default_rng([7, seed])
    team, disk = random_game(generator, 2, radius=0.4, capture_radius=0.1)
    plan = ascent(team, disk, random_turns(generator, 2))
    assert_cannot_be_continued(team, disk, plan)


@pytest.mark.parametrize(
    ("places", "headings", "start"),
    [
        (
            [(-0.2315, 0.1395), (-0.1419, 0.4784), (-0.4148, -0.1814)],
            [-1.0067, 3.0495, 2.9859],
            [-1.597, -1.827, 3.113],
        ),
        (
            [(-0.051, 0.2421), (-0.3972, 0.1206), (0.085, -0.2576), (0.2221, -0.2926)],
            [-0.4696, 0.5243, -0.6815, -0.215],
            [2.297, -3.028, -1.345, 1.379],
        ),
    ],
)
def test_a_correction_that_leads_back_does_not_end_the_ascent(places, headings, start):
    plan = ascent(covey.Team(places, headings), covey.PursuerDisk(radius=0.1), start)
    assert plan.status is covey.PlanStatus.CONVERGED


@pytest.mark.parametrize("count", [2, 4, 6])
def test_a_critical_sequence_limits_every_plan(count):
    """At a maximum either one sequence alone is stationary or several are level."""
    generator = np.random.default_rng(count)
    for _ in range(5):
        team, disk = random_game(generator, count)
        plan = covey.plan(team, disk, starts=4)
        gradients = np.array(
            [
                kernel_calls.derivatives(team, disk, plan.turns, s)[0]
                for s in plan.critical_sequences
            ]
        )
        free = np.abs(plan.turns) < math.pi - 1e-12
        weights, residual = convex_combination_nearest_zero(gradients[:, free])
        assert weights.sum() == pytest.approx(1.0, abs=1e-9)
        assert residual <= STATIONARY


def convex_combination_nearest_zero(rows):
    """Weights >= 0 with sum 1 that make the rows cancel best, and what is left."""
    penalty = 1e4
    system = np.vstack([rows.T, penalty * np.ones(len(rows))])
    weights, _ = nnls(system, np.append(np.zeros(rows.shape[1]), penalty))
    weights /= weights.sum()
    return weights, float(np.abs(weights @ rows).max(initial=0.0))
