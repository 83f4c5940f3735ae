"""`covey instances` and `covey score`."""

from __future__ import annotations

import csv
import json
import sys
from pathlib import Path
from statistics import fmean

import pytest

import covey
from covey.cli import main
from covey.instances import files

NAMES = ("paper-2", "mixed-3", "mean", "least")

TEAM = """
import covey

class MyTeam:
    def start(self, seed):
        return flee

def flee(situation):
    return covey.turns_to(situation.team, situation.disk.headings_away(situation.team.positions))

class NeedsAnArgument:
    def __init__(self, turn):
        pass

def too_few(situation):
    return [0.0]

number = 3
"""


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A working folder with a module; what is imported from it is forgotten afterwards."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    (tmp_path / "my_module.py").write_text(TEAM)
    (tmp_path / "broken.py").write_text("import nothing_of_that_name")
    (tmp_path / "halted.py").write_text("1 / 0")
    yield
    for name in ("my_module", "broken", "halted"):
        sys.modules.pop(name, None)


def test_lists_every_game(capsys):
    assert main(["instances"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines[3:] if line.strip()] == files.instance_names()


def test_json_has_the_state_and_all_values_to_the_last_bit(capsys):
    assert main(["instances", "seen-4", "mixed-3", "--json"]) == 0
    seen, mixed = json.loads(capsys.readouterr().out)["instances"]
    game = covey.load_instance("seen-4")
    assert seen["pursuer"] == {
        "center": [2000.0, -1000.0],
        "radius": 690.0,
        "speed": 45.0,
        "capture_radius": 5.0,
    }
    assert seen["evaders"]["positions"] == game.team.positions.tolist()
    assert seen["plan"]["turns"] == game.plan.turns.tolist()
    assert seen["bracket"]["upper"] == game.bracket.upper
    assert mixed["name"] == "mixed-3"


def test_show_prints_the_state_as_a_scenario(capsys, tmp_path):
    assert main(["show", "mixed-3"]) == 0
    (tmp_path / "mine.toml").write_text(capsys.readouterr().out)
    assert covey.load_scenario("mine.toml").team == covey.load_instance("mixed-3").team


def test_checks_the_games_that_are_named(capsys):
    assert main(["instances", "paper-2", "simple-2", "--check"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines == ["paper-2: every number holds", "simple-2: every number holds"]


def test_a_number_that_does_not_hold_is_told_with_the_name_and_status_2(
    capsys, monkeypatch, tmp_path
):
    for path in (files.instance_path("paper-2"), files.values_path("paper-2")):
        (tmp_path / path.parent.name).mkdir()
        text = path.read_text("utf-8").replace("survival_time = 1.", "survival_time = 2.")
        (tmp_path / path.parent.name / path.name).write_text(text, "utf-8")
    monkeypatch.setattr(files, "_FOLDER", tmp_path)
    assert main(["instances", "--check"]) == 2
    said = capsys.readouterr()
    assert "paper-2: 3 mistakes" in said.out
    assert "\n  paper-2: plan.survival_time: is 2." in said.err


def test_scores_a_strategy_beside_others_and_saves_every_game(capsys):
    words = ["score", "my_module:MyTeam", "paper-2", "mixed-3", "-o", "scores.csv"]
    strategies = ("my_module:MyTeam", "straight-away", "iterative-open-loop")
    assert main([*words, "--beside", *strategies[1:]]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["game", *strategies] in lines
    rows = {line[0]: [*map(float, line[1:])] for line in lines if line and line[0] in NAMES}
    for own, same, planned in rows.values():
        assert own == same < 1.0 <= planned
    with Path("scores.csv").open() as file:
        games = list(csv.DictReader(file))
    shares = {
        (game, name): [
            float(row["share"])
            for row in games
            if (row["instance"], row["strategy"]) == (game, name)
        ]
        for game in ("paper-2", "mixed-3")
        for name in strategies
    }
    assert all(len(each) == 4 for each in shares.values())
    assert max(max(each) - min(each) for each in shares.values()) > 0.01
    for game in ("paper-2", "mixed-3"):
        least = [min(shares[game, name]) for name in strategies]
        assert rows[game] == pytest.approx(least, abs=5e-4)
    assert rows["mean"] == pytest.approx(
        [fmean(min(shares[game, name]) for game in ("paper-2", "mixed-3")) for name in strategies],
        abs=5e-4,
    )
    assert rows["least"][0] == min(rows["paper-2"][0], rows["mixed-3"][0])


def test_plays_the_games_of_a_size_where_none_is_named(capsys):
    words = ["score", "my_module:flee", "--evaders", "2", "--beside", "hold-course", "--json"]
    assert main(words) == 0
    scores = json.loads(capsys.readouterr().out)
    assert {each["instance"] for each in scores["my_module:flee"]} == {
        name for name in files.instance_names() if name.endswith("-2")
    }


def test_names_are_told_in_full_where_they_do_not_fit_in_a_line(capsys):
    beside = ["iterative-open-loop", "straight-away", "hold-course", "smallest-danger"]
    assert main(["score", "my_module:MyTeam", "paper-2", "--beside", *beside]) == 0
    text = capsys.readouterr().out
    assert "paper-2" in text
    assert "…" not in text


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("instances circle-31", '; did you mean "circle-30"?'),
        ("instances paper-2 --check --time-limit -1", "time_limit: expected a finite number >= 0"),
        ("instances paper-2 --check --json", "--json: leave it out with --check"),
        ("score my_module:flee circle-31", 'did you mean "circle-30"?'),
        ("score my_module", "expected module:name, such as my_module:MyTeam, got my_module"),
        ("score :flee", "expected module:name"),
        ("score nowhere:flee", "nowhere: can't be imported: ModuleNotFoundError"),
        ("score broken:flee", "broken: can't be imported: ModuleNotFoundError: No module named"),
        ("score halted:flee", "halted: can't be imported: ZeroDivisionError"),
        ("score my_module:fleee", 'the module has no fleee; did you mean "flee"?'),
        ("score my_module:NeedsAnArgument", "NeedsAnArgument() failed: TypeError"),
        ("score my_module:number", "my_module:number: evaders: "),
        ("score my_module:too_few", "my_module:too_few: evaders: "),
        ("score my_module:flee --beside nobody", "evaders: expected one of open-loop"),
        ("score my_module:flee --evaders 1", "evaders: expected a whole number >= 2"),
        ("score my_module:flee pairs-6", "pairs-6: my_module:flee: positions: expected none at"),
        ("score my_module:flee -o scores.txt", "expected a name that ends in .csv"),
    ],
)
def test_a_mistake_is_one_clear_line(words, said, capsys):
    assert main(words.split()) == 2
    error = capsys.readouterr().err
    assert said in error
    assert len(error.strip().splitlines()) == 1
