"""Whether an output can be written is known before the work, and no folder is made unasked."""

from __future__ import annotations

from pathlib import Path

import pytest

from covey import studies, views
from covey.cli import main
from covey.scenarios import Scenario

ONE = "[[team.evaders]]\nposition = [0.3, 0.4]\n"
LONG = "a" * 260
"""No file may have so long a name."""

FILES = [
    "simulate one.toml -o {}.parquet",
    "draw one.toml -o {}.png",
    "draw one.toml -o {}.svg --view plan",
    "draw one.toml -o {}.pdf --view game",
    "draw one.toml -o {}.gif",
    "draw one.toml -o {}.mp4 --view animation",
    "draw one.toml -o a.png --record {}.parquet",
    "draw compared -o {}.png",
]
FOLDERS = [
    "study one-study.toml --workers 1 -o {}",
    "study tournament --workers 1 -o {}",
    "reproduce --starts 1 --workers 1 -o {}",
    "yardstick --pairs 1 --cells 64 -o {}",
]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A working folder, in which nothing may be played or drawn."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "one.toml").write_text(ONE)
    (tmp_path / "one-study.toml").write_text("starts = 1\n")
    (tmp_path / "file").write_text("")
    (tmp_path / "compared").mkdir()
    for owner, name in (
        (Scenario, "simulate"),
        (Scenario, "plan"),
        (views, "draw_plan"),
        (views, "draw_control"),
        (studies, "comparison"),
    ):
        monkeypatch.setattr(owner, name, lambda *_: pytest.fail("work"), raising=False)
    for work in ("running.worker.play_start", "analysis.yardstick.measure"):
        monkeypatch.setattr(f"covey.studies.{work}", lambda *_, **__: pytest.fail("work"))
    return tmp_path


def refused(capsys, command):
    """The one line with which a command is refused; nothing new is in its folder."""
    before = set(Path().rglob("*"))
    assert main(command.split()) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert len(output.err.splitlines()) == 1
    assert set(Path().rglob("*")) == before
    return output.err.removeprefix("covey: ").removesuffix("\n")


@pytest.mark.parametrize("command", [*FILES, *FOLDERS])
def test_a_missing_folder_is_told_and_not_made(command, capsys):
    message = refused(capsys, command.format("missing/folder/a"))
    assert message.startswith("missing/folder/a")
    assert message.endswith(
        ": there is no folder missing/folder; make it first: mkdir -p missing/folder"
    )


@pytest.mark.parametrize("command", [*FILES, *FOLDERS])
def test_a_file_in_place_of_a_folder_is_told(command, capsys):
    message = refused(capsys, command.format("file/a"))
    assert message.startswith("file/a")
    assert message.endswith(": Not a directory")


@pytest.mark.parametrize("command", [*FILES, *FOLDERS])
def test_a_name_that_the_system_refuses_is_told(command, capsys):
    assert refused(capsys, command.format(LONG)).endswith(": File name too long")


@pytest.mark.parametrize("command", FOLDERS)
def test_a_file_of_the_folders_name_is_told(command, capsys):
    assert refused(capsys, command.format("file")) == "file: expected a folder, got a file"


@pytest.mark.parametrize("name", ["fig4", "fig5"])
def test_the_folders_of_both_studies_are_checked_before_the_paper_is_reproduced(
    name, folder, capsys
):
    (folder / "there").mkdir()
    (folder / "there" / name).write_text("")
    assert main(["reproduce", "-o", "there"]) == 2
    assert capsys.readouterr().err == f"covey: there/{name}: expected a folder, got a file\n"


def test_results_that_are_asked_for_without_a_folder_are_in_results(folder, monkeypatch, capsys):
    monkeypatch.undo()
    monkeypatch.chdir(folder)
    assert main(["study", "one-study.toml", "--workers", "1"]) == 0
    assert studies.load_study("results/one-study").is_complete
