"""A soak plays what it says, and stops at the first game that breaks a rule, with its seed."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

from soak import case

ROOT = Path(__file__).parents[2]
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


def test_an_interrupt_ends_it_and_it_still_tells_what_it_has(tmp_path):
    output = tmp_path / "soak.json"
    run = start(output, "--workers", 1, program=("-c", ANNOUNCED))
    assert run.stdout.readline() == "playing\n"
    run.send_signal(signal.SIGINT)
    shown, _ = run.communicate(timeout=30)
    assert run.returncode == 130, shown
    assert figures(output)["games"] > 0
