"""How long plans take, beside what others need for the same, kernels compiled, one core.

- warm: a replan one update later, from what is left of the last plan. This planner carries turns,
  sequences and weights over, IPOPT its multipliers, SLSQP has nothing but the turns to carry.
- cold: a plan from one start, straight flight away from the pursuer, for all the same.
- best: `covey.plan` by default, the best of many starts.
"""

from __future__ import annotations

import pytest

from replay import REPLAY
from rounds import SIZES, measure, pairs, warm_up
from tables import rows

LEAST_EQUAL, LEAST_SETTLED = 0.5, 0.8
"""Shares of games in which a warm replan comes to the same value as this planner's, and in which
what a method ends with is a local maximum."""

CASES = [
    pytest.param(size, task, method.name, id=f"{size}-{task}-{method.name}")
    for size in SIZES
    for method, task in pairs(size)
]


@pytest.fixture(scope="module", autouse=True)
def _compiled():
    warm_up()


@pytest.mark.benchmark(timer=REPLAY.now)
@pytest.mark.parametrize(("size", "task", "method"), CASES)
def test_time(benchmark, size, task, method):
    solves = [s for s in measure(size) if (s.task, s.method) == (task, method)]
    benchmark.group = f"N = {size:2d}, {task}"
    REPLAY.run(benchmark, [solve.seconds for solve in solves])
    row = next(r for r in rows(measure(size)) if (r.task, r.method) == (task, method))
    benchmark.extra_info |= row._asdict()
    assert row.settled >= LEAST_SETTLED * row.games
    if task == "warm":
        assert row.equal >= LEAST_EQUAL * row.games
