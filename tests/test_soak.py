"""The soak plays what it says, and stops at the first game that breaks a rule, with its seed."""

from __future__ import annotations

import dataclasses
import itertools
import json
import math
import multiprocessing
import os
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import covey
from covey.players.teams.contingent import Flight
from kernels.contingent import reference_tree
from random_games import random_game
from soak import answers, case, contingent, legal_game, players, trial, workers
from soak.__main__ import main
from soak.delays import ends

ROOT = Path(__file__).parents[1]
FIRST = 300

BOAST = """
import dataclasses
import covey
from soak.__main__ import main

honest = covey.simulate


def boasting(team, disk, **settings):
    game = honest(team, disk, **settings)
    return dataclasses.replace(game, guarantee=2.0 * game.guarantee) if len(team) == 4 else game


covey.simulate = boasting
if __name__ == "__main__":
    raise SystemExit(main())
"""
"""A covey that claims too much of its plans for four evaders, in the workers too."""

ANNOUNCED = """
from soak import summary
from soak.__main__ import main

add = summary.Summary.add


def announce_once(self, report):
    add(self, report)
    summary.Summary.add = add
    print("playing", flush=True)


summary.Summary.add = announce_once
raise SystemExit(main())
"""
"""A soak that says when it has the first figures."""


def start(output, *arguments, program=("-m", "soak")):
    return subprocess.Popen(
        [sys.executable, *map(str, program), "--output", str(output), *map(str, arguments)],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "src")])},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def figures(output):
    return json.loads(output.read_text(encoding="utf-8"))


def test_a_few_dozen_games_keep_the_rules_on_any_number_of_workers(tmp_path):
    told = []
    for count in (1, 2):
        output = tmp_path / f"{count}.json"
        run = start(output, "--first", FIRST, "--games", 40, "--workers", count)
        shown, _ = run.communicate()
        assert run.returncode == 0, shown
        assert f"40 games from seed {FIRST}" in shown
        told.append(figures(output))
    for name in ("games", "rows", "stopped_at_the_time_limit", "kinds", "checks", "failure"):
        assert told[0][name] == told[1][name]
    assert told[0]["games"] == 40
    assert len(told[0]["memory"]["rows"][0]) == len(told[0]["memory"]["columns"])


def test_a_promise_that_is_not_kept_stops_it_with_the_seed(tmp_path):
    program, output = tmp_path / "boast.py", tmp_path / "soak.json"
    program.write_text(BOAST, encoding="utf-8")
    run = start(output, "--first", FIRST, "--games", 1000, "--workers", 1, program=(program,))
    shown, _ = run.communicate()
    assert run.returncode == 1, shown
    seed = figures(output)["failure"]["seed"]
    assert figures(output)["games"] == seed - FIRST
    assert f"make soak SEED={seed}" in shown
    assert len(case.draw(seed).team) == 4


def a_game_of_promises():
    """A case that is checked for the promises of its plan, and for nothing costly."""
    cases = map(case.draw, range(100))
    return next(each for each in cases if each.evaders.keeps_plan and not each.checks)


def test_the_seed_repeats_the_failure_and_shows_the_game(monkeypatch, capsys):
    honest = covey.simulate

    def boasting(*game, **settings):
        played = honest(*game, **settings)
        return dataclasses.replace(played, guarantee=2.0 * played.guarantee)

    seed = a_game_of_promises().seed
    assert main(["--seed", str(seed)]) == 0
    capsys.readouterr()
    monkeypatch.setattr(covey, "simulate", boasting)
    assert main(["--seed", str(seed)]) == 1
    shown = capsys.readouterr().out
    assert shown.startswith("guarantee is kept: ")
    assert f"seed {seed}\nteam = covey.Team(" in shown


@pytest.mark.parametrize("name", ["planned_value", "value"])
def test_a_value_that_is_no_number_is_a_failure(monkeypatch, name):
    honest = covey.simulate

    def broken(*game, **settings):
        return dataclasses.replace(honest(*game, **settings), **{name: math.nan})

    monkeypatch.setattr(covey, "simulate", broken)
    seed = a_game_of_promises().seed
    with pytest.raises(trial.ViolationError):
        trial.play(seed)


def test_an_error_in_a_game_is_a_failure_of_its_seed(monkeypatch, capsys):
    monkeypatch.setattr(covey, "simulate", lambda *game, **settings: 1 / 0)
    assert main(["--seed", "5"]) == 1
    assert capsys.readouterr().out.startswith("ZeroDivisionError: division by zero")


def test_an_interrupt_ends_it_and_it_still_tells_what_it_has(tmp_path):
    output = tmp_path / "soak.json"
    run = start(output, "--workers", 1, program=("-c", ANNOUNCED))
    assert run.stdout.readline() == "playing\n"
    run.send_signal(signal.SIGINT)
    shown, _ = run.communicate(timeout=30)
    assert run.returncode == 130, shown
    assert figures(output)["games"] > 0


class Worker:
    """A process that has ended, or that never reports."""

    def __init__(self, exitcode):
        self.exitcode, self.killed = exitcode, False

    def join(self):
        pass

    def kill(self):
        self.killed = True


@pytest.mark.parametrize(
    ("exitcode", "reason"), [(-11, "the worker died, exit -11"), (None, "no end after 0.05 s")]
)
def test_a_worker_that_is_lost_is_a_failure_of_the_seed_it_played(monkeypatch, exitcode, reason):
    ours, theirs = multiprocessing.Pipe(duplex=False)
    if exitcode is not None:
        theirs.close()
    worker = Worker(exitcode)
    started = (ours, worker, SimpleNamespace(value=77))
    monkeypatch.setattr(workers, "_start", lambda number, share: started)
    monkeypatch.setattr(workers, "REPORT_EVERY", 0.01)
    monkeypatch.setattr(workers, "PATIENCE", 0.05)
    told = workers.reports(70, None, 1)
    assert next(told).failure == (77, f"seed 77: {reason}")
    told.close()
    assert worker.killed == (exitcode is None)


def test_every_strategy_that_comes_with_covey_takes_part():
    team, disk = random_game(np.random.default_rng(0), 2)
    setting = players.Setting(team, disk, "visible", 1.0, 0.1)
    generator, kinds = np.random.default_rng(0), [players.downhill]
    for table in ("COMPILED", "INTERPRETED"):
        kinds += [*getattr(players, f"{table}_TEAMS"), *getattr(players, f"{table}_PURSUERS")]
    drawn = {type(kind(generator, setting).strategy) for kind in kinds}
    known = {getattr(covey.players, name) for name in covey.players.__all__}
    strategies = {each for each in known if hasattr(each, "start")}
    assert strategies <= drawn
    assert len(strategies) > 15


@pytest.fixture(scope="module")
def answering():
    """A case of a team that answers captures, against a hidden pursuer that keeps to an order."""
    team, disk = random_game(np.random.default_rng(1), 3)
    return case.Case(
        seed=1,
        team=team,
        disk=disk,
        evaders=players.Player("contingent", covey.Contingent(), answers=True),
        pursuer=players.Player("in order", covey.FixedSequence([2, 0, 1]), ends=True),
        sensing="hidden",
        objective=covey.LastCapture(),
        update_time=0.2,
        time_limit=None,
        checks=frozenset(),
    )


def play(each):
    players = {"evaders": each.evaders.strategy, "pursuer": each.pursuer.strategy}
    return covey.simulate(each.team, each.disk, **players, **each.settings())


def test_a_team_that_promises_less_than_before_is_found(answering, monkeypatch):
    assert max(contingent.promises(answering, play(answering)).values()) < 1e-12
    honest = Flight.__call__

    def boasting(flight, situation):
        turns = honest(flight, situation)
        flight.promise *= 1.0 if situation.time > 0.0 else 1.1
        return turns

    monkeypatch.setattr(Flight, "__call__", boasting)
    found = contingent.promises(answering, play(answering))
    assert found["promises of answers never fall"] > 0.05


def test_a_team_that_dies_before_its_promise_is_found(answering):
    game = play(answering)
    early = dataclasses.replace(game, survival_time=0.5 * game.survival_time)
    found = contingent.promises(answering, early)
    assert found["promise with delays is kept"] > 0.1
    assert found["the noted game is the same"] > 0.1


@pytest.mark.parametrize(
    ("depth", "factor", "check"),
    [
        (0, 0.99, "depth 0 is the open-loop plan"),
        (2, 0.9, "a deeper plan never promises less"),
        (2, 3.0, "answers below the upper end"),
    ],
)
def test_a_plan_that_answers_captures_wrongly_is_found(
    answering, monkeypatch, depth, factor, check
):
    assert max(contingent.plans(answering, None).values()) < 1e-12
    honest = covey.plan_contingent

    def wrong(team, disk, k, seed):
        tree = honest(team, disk, k, seed=seed)
        time = tree.survival_time * (factor if k == depth else 1.0)
        return dataclasses.replace(tree, survival_time=time)

    monkeypatch.setattr(covey, "plan_contingent", wrong)
    assert contingent.plans(answering, None)[check] > 1e-3


@pytest.mark.parametrize("depth", [0, 1, 2])
def test_plays_with_delays_are_flown_as_by_recursion(depth):
    generator = np.random.default_rng(depth)
    team, disk = random_game(generator, 3, radius=0.1, capture_radius=0.02)
    tree = covey.plan_contingent(team, disk, depth)
    sequences = np.array(list(itertools.permutations(range(3))))
    delays = generator.exponential(0.3, (6, 3)) * [1.0, 1.0, 0.0]
    delays[:, depth:] = 0.0  # the recursion knows delays of answered captures only
    found = ends(tree, sequences, delays)
    for sequence, put_off, end in zip(sequences.tolist(), delays.tolist(), found, strict=True):
        times = reference_tree.times(team, disk, tree.node.turns, depth, sequence, put_off)
        assert end == pytest.approx(times[-1], rel=1e-9)
    assert ends(tree, sequences, np.zeros((6, 3))).min() == pytest.approx(tree.survival_time)


def test_teams_that_answer_captures_keep_their_promises(capsys):
    assert answers.main(["--trees", "2", "--plays", "200", "--minutes", "0.02"]) == 0
    assert "none below what is guaranteed" in capsys.readouterr().out


def test_a_play_that_ends_too_early_is_found(monkeypatch):
    monkeypatch.setattr(answers, "ends", lambda *play: 0.9 * ends(*play))
    with pytest.raises(SystemExit, match="start 0, 3 evaders"):
        answers.main(["--trees", "1", "--plays", "200"])


@pytest.fixture(scope="module", params=["hidden", "visible"])
def game(request):
    team, disk = random_game(np.random.default_rng(1), 3, radius=0.1, capture_radius=0.05)
    return covey.simulate(team, disk, sensing=request.param, update_time=0.2)


def changed(game, name, index, by):
    values = getattr(game, name).copy()
    values[index] += by
    return dataclasses.replace(game, **{name: values})


@pytest.mark.parametrize(
    ("name", "index", "by", "check"),
    [
        ("guarantees", 2, math.nan, "numbers are finite"),
        ("times", 3, -0.5, "times are in order"),
        ("evader_positions", (2, 0, 1), 1e-9, "everyone flies what was announced"),
        ("evader_headings", (2, 1), 1e-9, "everyone flies what was announced"),
        ("evader_positions", (2, 0, 1), 1.0, "nobody is faster than it can be"),
        ("evader_headings", (2, 1), 1.0, "nobody is faster than it can be"),
        ("capture_times", 1, 1e-9, "each capture is a row of its own"),
        ("capture_sequence", 1, 1, "each capture is a row of its own"),
        ("evader_positions", (slice(None), slice(None), 0), 1.0, "who is captured is within reach"),
        ("guarantees", -1, 1e-9, "the last row is the end"),
    ],
)
def test_a_record_that_breaks_a_rule_is_found(game, name, index, by, check):
    assert max(legal_game.errors(game).values()) < 1e-13
    assert legal_game.errors(changed(game, name, index, by))[check] > 1e-10


def test_a_game_that_is_stopped_too_soon_is_found():
    team, disk = random_game(np.random.default_rng(1), 3)
    stopped = covey.simulate(team, disk, time_limit=0.1)
    assert legal_game.errors(stopped, 0.1)["the last row is the end"] < 1e-13
    assert legal_game.errors(stopped, 0.2)["the last row is the end"] > 0.1
    updates = dataclasses.replace(stopped, status=covey.GameStatus.UPDATE_LIMIT)
    assert legal_game.errors(updates, 0.1)["the last row is the end"] == math.inf


@pytest.mark.parametrize(
    ("name", "index", "by", "check", "sensing"),
    [
        ("pursuer_positions", (3, 0), 1.0, "the pursuer is no faster than it can be", "visible"),
        ("pursuer_positions", (3, 0), 1e-9, "a visible pursuer is where its disk is", "visible"),
        (
            "pursuer_positions",
            (slice(None), slice(None)),
            0.03,
            "a pursuer takes whomever it comes near",
            "visible",
        ),
        ("disk_radii", 3, 1e-9, "a hidden pursuer is a disk that grows and collapses", "hidden"),
        (
            "disk_centers",
            (3, 0),
            1e-9,
            "a hidden pursuer is a disk that grows and collapses",
            "hidden",
        ),
    ],
)
def test_a_pursuer_that_breaks_a_rule_is_found(game, name, index, by, check, sensing):
    if game.sensing == sensing:
        assert legal_game.errors(changed(game, name, index, by))[check] > 1e-10
