"""A scenario to start from, the files that come with covey, and shells that complete commands."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

import covey
from covey import scenarios, studies
from covey.cli import main
from covey.cli.app import COMMANDS


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_a_new_scenario_can_be_planned_as_it_stands(capsys):
    assert main(["new", "mine.toml"]) == 0
    assert capsys.readouterr().err == "saved mine.toml\n"
    assert main(["plan", "mine.toml"]) == 0
    assert "guaranteed survival time" in capsys.readouterr().out


def test_a_new_scenario_is_the_situation_that_it_tells():
    assert main(["new", "mine.toml"]) == 0
    scenario = covey.load_scenario("mine.toml")
    assert scenario.disk.radius == 150 + 45 * 12
    assert scenario.team.turn_rates[:2].tolist() == [20 / 60] * 2


def test_the_tables_of_a_new_scenario_name_its_units(capsys):
    assert main(["new", "mine.toml"]) == 0
    assert main(["plan", "mine.toml", "--contingent"]) == 0
    text = capsys.readouterr().out
    assert re.search(r"guaranteed survival time +[\d.]+ s *\n", text)
    assert "position (m)" in text
    assert "( 900,  300)" in text  # metres, with the decimals of the largest
    header, *answers = text[text.index(" captured ") :].splitlines()
    assert header.rstrip().endswith("then survives (s)")
    times = [line.split()[-1] for line in answers if line.strip()[:1] in list("0123")]
    assert [len(time.partition(".")[2]) for time in times] == [3] * 4
    assert main(["simulate", "mine.toml"]) == 0
    text = capsys.readouterr().out
    assert re.search(r"survival time +[\d.]+ s  \(\d\.\d\d times the guarantee\)", text)
    assert "time (s)" in text
    assert "place (m)" in text
    assert main(["worst-case", "mine.toml"]) == 0
    text = capsys.readouterr().out
    assert re.search(r"least survival time +[\d.]+ s *\n", text)
    assert "waited (s)" in text


def test_a_file_that_exists_is_left_as_it_is(capsys):
    Path("mine.toml").write_text("mine")
    assert main(["new", "mine.toml"]) == 2
    message = "covey: mine.toml: exists already; choose another name, or remove it\n"
    assert capsys.readouterr().err == message
    assert Path("mine.toml").read_text() == "mine"


def test_a_new_scenario_needs_the_name_of_one(capsys):
    assert main(["new", "mine.json"]) == 2
    assert "expected a name that ends in .toml for a scenario" in capsys.readouterr().err


@pytest.mark.parametrize("room", [scenarios, studies])
def test_what_comes_along_is_shown_to_the_last_byte(room, capsysbinary):
    for name in room.example_names():
        assert main(["show", name]) == 0
        assert capsysbinary.readouterr().out == room.example_path(name).read_bytes()


def test_an_unknown_name_is_told_with_those_that_exist(capsys):
    assert main(["show", "fig33"]) == 2
    error = capsys.readouterr().err
    for name in (*scenarios.example_names(), *studies.example_names()):
        assert name in error
    assert error.endswith("got 'fig33'\n")


def test_a_study_may_be_played_from_fewer_starts(capsys):
    Path("small.toml").write_text("starts = 300\n[grid]\nteam_size = 2\nupdate_time = 0.1\n")
    assert main(["study", "small.toml", "--starts", "3", "--workers", "1"]) == 0
    assert "Means over 3 starts" in capsys.readouterr().out
    assert covey.load_study("results/small-3-starts").games.num_rows == 6
    assert main(["study", "small.toml", "--starts", "0"]) == 2
    assert "starts: expected a whole number >= 1, got 0" in capsys.readouterr().err


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_learns_the_commands(shell, tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    assert main(["--install-completion", "--shell", shell]) == 0
    scripts = [path.read_text() for path in tmp_path.rglob("*") if path.is_file()]
    (script,) = [text for text in scripts if "reproduce" in text]
    for name in COMMANDS:
        assert name.replace("_", "-") in script


def bash_completes(line: str) -> list[str]:
    """Return what bash, in the folder of the test, offers for the last word of a line."""
    words = line.split(" ")
    asked = f"COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _covey"
    answer = f'source ~/.bashrc; {asked}; echo "${{COMPREPLY[@]}}"'
    done = subprocess.run(["bash", "-c", answer], capture_output=True, text=True, check=True)
    return done.stdout.split()


def test_bash_reads_what_was_written_for_it(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    assert main(["--install-completion", "--shell", "bash"]) == 0
    assert bash_completes("covey wor") == ["worst-case"]


@pytest.mark.parametrize("command", ["plan", "simulate", "worst-case", "study", "draw", "new"])
def test_bash_completes_the_names_of_files(command, tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    Path("mine.toml").touch()
    assert main(["--install-completion", "--shell", "bash"]) == 0
    assert bash_completes(f"covey {command} mi") == ["mine.toml"]
