"""One game of a seed: what goes wrong in it is a failure of that seed."""

from __future__ import annotations

import dataclasses
import math

import pytest

import covey
from soak import case, trial
from soak.__main__ import main


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
