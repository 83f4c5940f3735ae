"""The exit status of every command: after success, a mistake, a fault of the disk, Ctrl-C."""

from __future__ import annotations

import sys

import pytest

import covey
from covey.cli import main
from covey.cli.app import COMMANDS
from covey.kernels.library.errors import BuildError

WORDS = {
    "new": "new mine.toml",
    "show": "show fig3",
    "schema": "schema scenario",
    "plan": "plan one.toml",
    "simulate": "simulate one.toml -o game.parquet",
    "worst_case": "worst-case one.toml",
    "draw": "draw game.parquet -o game.png",
    "study": "study tiny.toml --workers 1 -o tiny",
    "reproduce": "reproduce --starts 2 --workers 1 -o paper",
    "yardstick": "yardstick --pairs 1 --cells 64 -o measured",
    "instances": "instances paper-2 --check",
    "score": "score my_team:flee paper-2 --beside hold-course",
    "chase": "chase --no-browser --port 0",
    "notebook": "notebook mine.ipynb --no-browser",
    "warmup": "warmup",
}
WORK = {
    "new": "covey.cli.commands.new.write_text",
    "show": "covey.scenarios.example_path",
    "schema": "covey.scenarios.json_schema.json_schema",
    "plan": "covey.scenarios.Scenario.bracket",
    "simulate": "covey.scenarios.Scenario.simulate",
    "worst_case": "covey.scenarios.Scenario.worst_case",
    "draw": "covey.views.kit.saving.Figure.savefig",
    "study": "covey.studies.running.run.Scheduler.run",
    "reproduce": "covey.scenarios.Scenario.simulate",
    "yardstick": "covey.studies.analysis.yardstick.measure",
    "instances": "covey.instances.check.check",
    "score": "covey.cli.commands.score.counting",
    "chase": "covey.web.serving.server.serve",
    "notebook": "covey.cli.show.notebook.run_notebook",
    "warmup": "covey.cli.commands.warmup.load_library",
}
"""What each command does after it has checked its arguments."""

EACH = pytest.mark.parametrize("command", COMMANDS)


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A working folder with a scenario, a record, a study, a notebook and a module."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    (tmp_path / "my_team.py").write_text("def flee(situation):\n    return situation.turns\n")
    (tmp_path / "one.toml").write_text("[[team.evaders]]\nposition = [0.3, 0.4]\n")
    (tmp_path / "tiny.toml").write_text("starts = 2\n[grid]\nteam_size = 1\nupdate_time = 0.2\n")
    (tmp_path / "mine.ipynb").write_text('{"cells": [{"cell_type": "code", "source": ["1"]}]}')
    game = covey.simulate(covey.Team([[0.3, 0.4]], [0.9]), covey.PursuerDisk(), update_time=0.5)
    covey.save_game(game, "game.parquet")


def status(monkeypatch, command, error):
    """The status of a command whose work ends with an error; its arguments are good."""

    def fail(*arguments, **options):
        raise error

    monkeypatch.setattr(WORK[command], fail)
    return main(WORDS[command].split())


def test_every_command_is_tried():
    assert WORDS.keys() == WORK.keys() == set(COMMANDS)


# `reproduce` and `yardstick` have tests of their own, and `chase` serves until Ctrl-C.
@pytest.mark.parametrize(
    "command", [each for each in COMMANDS if each not in ("reproduce", "yardstick", "chase")]
)
def test_success_is_0(command):
    assert main(WORDS[command].split()) == 0


@EACH
def test_an_unknown_option_is_2(command, capsys):
    assert main([*WORDS[command].split(), "--nonsense"]) == 2
    assert "Unknown option: --nonsense" in capsys.readouterr().err


@EACH
@pytest.mark.parametrize(
    ("error", "expected", "said"),
    [
        (covey.InputError("a mistake"), 2, "covey: a mistake"),
        (OSError(28, "No space left on device", "there"), 2, "No space left on device"),
        (BuildError("no compiler"), 2, "covey: no compiler"),
        (KeyboardInterrupt(), 130, "covey: stopped"),
    ],
    ids=lambda each: type(each).__name__,
)
def test_work_that_fails_ends_with_its_status(command, error, expected, said, monkeypatch, capsys):
    assert status(monkeypatch, command, error) == expected
    errors = capsys.readouterr().err
    assert said in errors
    assert "Traceback" not in errors


@EACH
def test_a_fault_of_the_program_is_not_hidden(command, monkeypatch):
    with pytest.raises(ValueError, match="not the user's mistake"):
        status(monkeypatch, command, ValueError("not the user's mistake"))
