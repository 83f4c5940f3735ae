"""Scratch is carved from a workspace: all of it fits, and the next call finds the same arrays."""

from __future__ import annotations

import gc
import subprocess
import sys
import tracemalloc
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import covey
from covey.kernels.arrays import new_workspace
from covey.kernels.maximum.multistart import refine
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.maximum.values import minimum_over_sequences
from covey.kernels.maximum.working_set import new_working_set
from covey.model import LastCapture, TotalSurvival
from covey.planning.border import about_center, pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.workspace import LARGEST_KEPT, SMALL, workspace
from random_games import random_game


@pytest.mark.parametrize("total", [False, True])
@pytest.mark.parametrize("size", range(1, 13))
def test_a_workspace_holds_all_scratch_of_its_size(size, total):
    team, disk = random_game(np.random.default_rng(size), size)
    memory = new_workspace(size, total)
    objective = compiled_objective(TotalSurvival() if total else LastCapture(), size)
    problem = Problem(team.as_rows(), pursuit_of(disk), objective)
    iterate = Iterate(np.zeros(size), new_working_set(size))
    options = Options(0.2, 1e-9, 20)
    for _ in range(2):
        refine(problem, np.empty((0, size)), 0, options, -np.inf, iterate, memory)
        for used, buffer in zip(
            memory.carved, (*memory[5:10], memory.ints, memory.int_rows), strict=True
        ):
            assert 0 < used <= len(buffer)


def test_a_smaller_team_fits_into_the_workspace_of_a_larger_one():
    team, disk = about_center(*random_game(np.random.default_rng(0), 4))
    turns = np.full(4, 0.3)
    rows, sequence = team.as_rows(), np.empty(4, np.int64)
    time = minimum_over_sequences(
        rows, turns, pursuit_of(disk), False, np.inf, sequence, new_workspace(9)
    )
    expected = covey.guaranteed_survival(team, disk, turns)
    assert (time, tuple(sequence.tolist())) == (expected.time, expected.sequence)


def test_a_thread_keeps_workspaces_and_one_large_one():
    assert workspace(5) is workspace(5)
    assert workspace(5) is not workspace(5, total=True)
    large = workspace(SMALL + 1)
    assert workspace(SMALL + 1) is large
    assert workspace(SMALL + 2) is workspace(SMALL + 2)
    assert workspace(SMALL + 1) is not large
    assert workspace(LARGEST_KEPT + 1) is workspace(LARGEST_KEPT + 1)
    sums = workspace(LARGEST_KEPT + 1, total=True)
    assert workspace(LARGEST_KEPT + 1, total=True) is not sums


def test_each_thread_has_its_own():
    with ThreadPoolExecutor(1) as executor:
        assert executor.submit(workspace, 5).result() is not workspace(5)


def test_a_policy_may_be_asked_from_any_thread():
    """Two games whose team plans in one thread, then in another, at the same time."""
    team, disk = random_game(np.random.default_rng(3), 6)
    situations = [
        covey.Situation(0.0, tuple(range(6)), team, disk, np.zeros(6)),
        covey.Situation(0.01, tuple(range(6)), team, disk, np.full(6, 0.1)),
    ]
    strategy = covey.IterativeOpenLoop(starts=2)
    alone = strategy.start(0)
    expected = [alone(each) for each in situations]
    policies = [strategy.start(0) for _ in range(8)]
    for policy in policies:
        policy(situations[0])
    with ThreadPoolExecutor(8) as executor:
        for turns in executor.map(lambda policy: policy(situations[1]), policies):
            assert turns.tolist() == expected[1].tolist()


def test_plans_from_eight_threads_are_those_of_one():
    games = [random_game(np.random.default_rng(seed), 2 + seed % 6) for seed in range(24)]

    def told(game):
        plan = covey.plan(*game, starts=3)
        return plan.turns.tolist(), plan.survival_time, plan.critical_sequences, plan.steps

    with ThreadPoolExecutor(8) as executor:
        assert list(executor.map(told, games)) == list(map(told, games))


FIRST_CALLS = """
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
import numpy as np
import covey
from random_games import random_game

team, disk = random_game(np.random.default_rng(4), 9)
together = Barrier(8)

def plan(_):
    together.wait()
    plan = covey.plan(team, disk, starts=8)
    return plan.turns.tolist(), plan.survival_time, plan.critical_sequences

with ThreadPoolExecutor(8) as executor:
    print({repr(each) for each in executor.map(plan, range(8))})
"""


def test_the_first_plans_of_a_process_may_come_from_eight_threads():
    plan = covey.plan(*random_game(np.random.default_rng(4), 9), starts=8)
    alone = plan.turns.tolist(), plan.survival_time, plan.critical_sequences
    done = subprocess.run(
        [sys.executable, "-c", FIRST_CALLS],
        cwd=Path(__file__).parents[1],  # has random_games
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert (done.stdout, done.stderr) == (f"{ {repr(alone)} }\n", "")


def test_calls_keep_no_memory():
    game = random_game(np.random.default_rng(5), 5)
    strategy = covey.IterativeOpenLoop(starts=1)

    def use():
        for _ in range(100):
            covey.guaranteed_survival(*game, np.zeros(5))
            covey.plan(*game, starts=1)
        covey.simulate(*game, evaders=strategy, update_time=0.5)

    def traced():
        use()
        gc.collect()
        return tracemalloc.get_traced_memory()[0]

    tracemalloc.start()
    try:
        for _ in range(4):  # the first calls fill caches of Python's
            before = traced()
        use()
        after = traced()
    finally:
        tracemalloc.stop()
    assert after - before < 10_000
