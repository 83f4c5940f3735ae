"""Long calls: interrupts end them early, and a time limit leaves an exact plan."""

import os
import signal
import subprocess
import sys
import threading

import numpy as np
import pytest

import covey
from covey.kernels.contingent.scratch import new_branches
from covey.kernels.contingent.tree import tree_sizes
from covey.planning import long_calls
from covey.planning.border import about_center, pursuit_of
from covey.planning.contingent import search
from covey.planning.contingent.moment import Moment
from covey.planning.long_calls import LONG, interruptible, new_flag
from covey.planning.workspace import workspace
from covey.players.pursuers import commitment
from covey.players.teams import open_loop
from covey.simulation import match
from covey.simulation.settings import Settings
from random_games import random_game

DAYS = {
    "a plan for twenty": "covey.plan(team(20), disk, starts=10**4)",
    "one start for fifty": "covey.plan(team(50), disk, starts=1)",
    "many starts of a small team": "covey.plan(team(4), disk, starts=10**5)",
    "a plan for a sum": "covey.plan(team(16), disk, objective=covey.TotalSurvival(), starts=10**4)",
    "a plan for an expectation": (
        "covey.plan(team(8), disk, objective=covey.ExpectedSurvival(), starts=10**4)"
    ),
    "a game": "while True: covey.simulate(team(9), disk, update_time=0.0005)",
    "a worst case": "while True: covey.worst_case(team(4), disk, update_time=0.00002)",
}
"""Calls that take far longer than any test waits."""

PROGRAM = """
import signal
import numpy as np
import covey

signal.signal(signal.SIGINT, signal.default_int_handler)  # also where a shell's background has none

def team(n):
    generator = np.random.default_rng(1)
    positions = generator.uniform(-0.5, 0.5, (n, 2))
    return covey.Team(positions, generator.uniform(-3.0, 3.0, n), 0.5, 2.0)

disk = covey.PursuerDisk()
covey.plan(team(3), disk)
print("ready", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.skipif(os.name == "nt", reason="there, a process can't send the signal of Ctrl-C")
@pytest.mark.parametrize("call", DAYS.values(), ids=DAYS)
def test_an_interrupt_ends_a_long_call(call):
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM.format(call=call)], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout.readline() == "ready\n"
            with pytest.raises(subprocess.TimeoutExpired):
                process.wait(0.5)
            process.send_signal(signal.SIGINT)
            output, _ = process.communicate(timeout=60.0)
        finally:
            process.kill()
    assert (output, process.returncode) == ("interrupted\n", 0)


@pytest.mark.parametrize("size", [3, 14])
@pytest.mark.parametrize("objective", [covey.LastCapture(), covey.TotalSurvival()])
def test_a_plan_that_ran_out_of_time_is_exact(size, objective):
    team, disk = random_game(np.random.default_rng(size), size)
    found = covey.plan(team, disk, objective=objective, starts=10**4, time_limit=0.05)
    guarantee = covey.guaranteed_survival(team, disk, found.turns, objective=objective)
    assert found.status == covey.PlanStatus.TIME_LIMIT
    assert found.value == pytest.approx(guarantee.time, rel=1e-12)


def test_a_plan_without_time_evaluates_its_first_turns():
    team, disk = random_game(np.random.default_rng(0), 5)
    found = covey.plan(team, disk, time_limit=0.0, warm_start=np.zeros(5))
    assert found.value >= covey.guaranteed_survival(team, disk, np.zeros(5)).time


def test_many_starts_of_a_small_team_give_the_same_plan_in_one_thread_and_in_several():
    team, disk = random_game(np.random.default_rng(7), 4)
    alone, shared = (covey.plan(team, disk, starts=64, time_limit=limit) for limit in (None, 1e6))
    assert np.array_equal(alone.turns, shared.turns)
    assert (alone.value, alone.starts, alone.steps) == (shared.value, shared.starts, shared.steps)


def test_a_call_has_the_flag_of_its_workspace_alone():
    seen = []

    def call(scratch):
        seen.append(scratch.stop)
        return len(seen)

    assert [interruptible(call, 3, False, work) for work in (0.0, 2.0 * LONG)] == [1, 2]
    assert seen[0] is workspace(3).stop
    assert seen[1] is not seen[0]
    assert list(seen[1]) == list(new_flag())


@pytest.fixture
def threads_of(monkeypatch):
    """Return a function that lets a kernel, as a module calls it, note in which thread it runs.

    A call is long from a millisecond on.
    """
    monkeypatch.setattr(long_calls, "LONG", 1e5)

    def watch(module, kernel):
        seen, call = [], getattr(module, kernel)

        def noted(*arguments):
            seen.append(threading.get_ident())
            return call(*arguments)

        monkeypatch.setattr(module, kernel, noted)
        return seen

    return watch


def test_an_ascent_on_a_large_tree_runs_in_another_thread(threads_of):
    seen = threads_of(search, "ascend_tree")
    for n in (3, 5):
        team, disk = about_center(*random_game(np.random.default_rng(n), n))
        moment = Moment(team.as_rows(), pursuit_of(disk))
        search.ascend(moment, 2, np.zeros(tree_sizes(n, 2)[0]), new_branches(n))
    assert seen[0] == threading.get_ident() != seen[1]


def test_a_game_of_a_large_team_in_python_computes_in_other_threads(threads_of):
    kernels = (open_loop, "replan"), (commitment, "commit"), (match, "write_row")
    seen = [threads_of(module, kernel) for module, kernel in kernels]
    team, disk = random_game(np.random.default_rng(1), 14)
    settings = Settings("hidden", 0.05, 1, 12.0)
    evaders = covey.IterativeOpenLoop(starts=1, restarts=0)
    match.Match(team, disk, evaders, covey.CommittedPursuer(), settings).step()
    assert all(seen)
    assert threading.get_ident() not in {thread for each in seen for thread in each}
