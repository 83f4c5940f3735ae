"""The examples run, and what they print is true."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"

PRINTED = 0.0005
"""Half of the last digit of what is printed."""


def run(name, capsys):
    """The lines that an example prints, and the names it leaves behind."""
    names = runpy.run_path(str(EXAMPLES / name))
    return capsys.readouterr().out.splitlines(), names


def last_number(line):
    return float(re.findall(r"\d+\.\d+", line)[-1])


def test_first_game(capsys):
    lines, names = run("first_game.py", capsys)
    guaranteed, *captures, survived = map(last_number, lines)
    game = names["game"]
    assert guaranteed == pytest.approx(names["plan"].survival_time, abs=PRINTED)
    assert captures == pytest.approx(game.capture_times.tolist(), abs=PRINTED)
    assert captures == sorted(captures)
    assert survived == captures[-1] >= guaranteed


def test_own_strategy(capsys):
    lines, _ = run("own_strategy.py", capsys)
    survived = {}
    for line in lines:
        names, numbers = line.split(": ")
        survived[names], guaranteed = map(float, re.findall(r"\d+\.\d+", numbers))
        if names.startswith("iterative"):
            assert survived[names] >= guaranteed - PRINTED
    assert [*survived] == [
        f"{team} against {pursuer}"
        for team in ("away", "iterative-open-loop")
        for pursuer in ("nearest_first", "committed")
    ]
    for team in ("away", "iterative-open-loop"):
        assert survived[f"{team} against committed"] < survived[f"{team} against nearest_first"]
