"""Another solver, on all N! sequences at once, finds nothing better than the planner.

SciPy's SLSQP takes eq. (6) as it stands: maximise z subject to z <= f_s for every sequence s.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize

import covey
from kernels import kernel_calls, reference_game
from random_games import random_game, random_turns

SLSQP_STARTS = {2: 10, 3: 16, 4: 24}
BETTER_AT_MOST = 1e-6
"""By how much SLSQP may beat the planner, relative."""
CLOSE = 1e-4
"""Where SLSQP counts as having found the planner's maximum, relative."""


def best_by_slsqp(team, disk, generator):
    n = len(team)
    values = kernel_calls.times_of_sequences(team, disk, reference_game.every_sequence(n))
    bounds = [(-math.pi, math.pi)] * n + [(0.0, None)]
    upwards = np.append(np.zeros(n), -1.0)
    best = 0.0
    for _ in range(SLSQP_STARTS[n]):
        turns = random_turns(generator, n)
        answer = minimize(
            lambda v: -v[-1],
            np.append(turns, values(turns).min()),
            jac=lambda v: upwards,
            bounds=bounds,
            constraints={"type": "ineq", "fun": lambda v: values(v[:-1]) - v[-1]},
            method="SLSQP",
            options={"maxiter": 60, "ftol": 1e-10},
        )
        best = max(best, values(np.clip(answer.x[:-1], -math.pi, math.pi)).min())
    return best


@pytest.mark.parametrize(
    "options", [{}, {"radius": 0.1, "mixed": True}, {"capture_radius": 0.03}], ids=str
)
@pytest.mark.parametrize(("count", "how_many"), [(2, 12), (3, 8), (4, 6)])
def test_slsqp_finds_nothing_better(count, how_many, options):
    generator = np.random.default_rng([count, len(options)])
    close = 0
    for _ in range(how_many):
        team, disk = random_game(generator, count, **options)
        plan = covey.plan(team, disk)
        best = best_by_slsqp(team, disk, generator)
        assert best <= plan.survival_time * (1.0 + BETTER_AT_MOST)
        close += best >= plan.survival_time * (1.0 - CLOSE)
    assert close > how_many / 2
