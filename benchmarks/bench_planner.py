"""How long plans take, beside what others need for the same, kernels compiled, one core.

- warm: a replan one update later, from what is left of the last plan. This planner carries turns,
  sequences and weights over, IPOPT its multipliers, SLSQP has nothing but the turns to carry.
- cold: a plan from one start, straight flight away from the pursuer, for all the same.
- best: `covey.plan` by default, the best of many starts.
"""

from __future__ import annotations

import pytest

from replay import REPLAY
from rounds import REFERENCE, SIZES, measure, pairs, warm_up
from tables import agreement

LEAST_AGREEMENT = {"warm": 0.75, "cold": 0.5, "best": 0.0}
"""Share of games in which a method comes to the same value as this planner; see `tables`."""

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
    if task != "best":
        same = agreement(measure(size), task, method)
        benchmark.extra_info |= same._asdict() | {"reference": REFERENCE}
        assert same.equal >= LEAST_AGREEMENT[task] * len(solves)
