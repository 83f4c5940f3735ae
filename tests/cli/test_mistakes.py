"""A mistake gets one message on standard error, exit status 2 and no traceback."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

import covey
from covey.cli import main

ONE_EVADER = "[[team.evaders]]\nposition = [0.3, 0.4]\n"


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A working folder with a scenario, a record and some files that are neither."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "one.toml").write_text(ONE_EVADER)
    (tmp_path / "empty.toml").write_text("")
    (tmp_path / "binary.toml").write_bytes(bytes(range(256)))
    (tmp_path / "half.parquet").write_bytes(b"PAR1 and no more")
    (tmp_path / "fast.toml").write_text(ONE_EVADER + "speed = 1\nturn_rat = nan\n")
    game = covey.simulate(covey.Team([[0.3, 0.4]], [0.9]), covey.PursuerDisk(), update_time=0.5)
    covey.save_game(game, tmp_path / "game.parquet")
    forged = dataclasses.replace(game, critical_sequences=game.critical_sequences + 99)
    covey.save_game(forged, tmp_path / "forged.parquet")
    return tmp_path


def refused(capsys, arguments):
    """The message with which a command line is refused, with nothing on the standard output."""
    assert main(arguments) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert output.err.startswith("covey: ")
    return output.err.removeprefix("covey: ")


def test_all_mistakes_of_a_file_are_printed_under_its_name(capsys):
    assert refused(capsys, ["plan", "fast.toml"]) == (
        "fast.toml: 2 mistakes\n"
        '  team.evaders[0].turn_rat: unknown key; did you mean "turn_rate"?\n'
        "  team.evaders[0].speed: expected every evader to be slower than the pursuer (1), or it "
        "could flee for ever; got 1\n"
    )


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("plan empty.toml", "empty.toml: 1 mistake\n  team.evaders: expected 1 to 50 evaders"),
        ("plan binary.toml", "binary.toml: expected a scenario in TOML, got a binary file"),
        ("plan .", ".: can't be read: "),
        (
            "plan none.toml",
            "none.toml: no such file, and no scenario of that name; with covey come everyone, ",
        ),
        (
            "plan fig33",
            "fig33: no such file, and no scenario of that name; with covey come everyone, fig3, "
            'uncertain, unequal, unseen, visible; did you mean "fig3"?',
        ),
        (
            "plan game.parquet",
            "game.parquet: expected a scenario in TOML, got a Parquet file; `covey draw` draws",
        ),
        ("plan one.toml --seed -1", "seed: expected a whole number >= 0, got -1"),
        ("draw half.parquet -o a.png", "half.parquet: the record is damaged or cut off"),
        (
            "draw forged.parquet -o a.png",
            "forged.parquet: it contradicts itself: critical_sequences: expected one evader less",
        ),
        ("draw binary.toml -o a.png", "binary.toml: expected a scenario in TOML, got a binary"),
        (
            "draw game.parquet -o a.jpg",
            "a.jpg: expected a name that ends in .png, .svg, .pdf, .gif or .mp4 for a picture or "
            "a film",
        ),
        (
            "draw game.parquet -o a.gif --view game",
            "a.gif: expected a name that ends in .png, .svg or .pdf for the view game",
        ),
        (
            "draw game.parquet -o a.png --view animation",
            "a.png: expected a name that ends in .gif or .mp4 for the view animation",
        ),
        ("draw game.parquet -o a.png --view plan", "the view plan needs a scenario, got the"),
        ("draw game.parquet -o a.png --seed 1", "--seed: game.parquet is the record of a game"),
        (
            "draw one.toml -o a.png --record a.txt",
            "a.txt: expected a name that ends in .parquet for the record of a game",
        ),
        (
            "draw one.toml -o a.png --view plan --record a.parquet",
            "--record: the view plan plays no game",
        ),
        (
            "draw one.toml -o a.png --view plan --depth 1",
            "--depth: expected the view tree, got plan",
        ),
        ("simulate one.toml -o game", "game: expected a name that ends in .parquet for the"),
        (
            "simulate one.toml -o one.toml/a.parquet",
            "one.toml/a.parquet: can't be written: Not a directory",
        ),
        ("reproduce -o one.toml", "one.toml: expected a folder, got a file"),
        ("reproduce -o new --starts 0", "study: starts: expected a whole number >= 1, got 0"),
        ("reproduce -o new --workers 0", "workers: expected a whole number >= 1, got 0"),
    ],
)
def test_a_mistake_is_told_in_one_message(line, message, capsys):
    assert refused(capsys, line.split()).startswith(message)
    assert not Path("new").exists()


@pytest.mark.parametrize(
    ("line", "message", "advice"),
    [
        ("pln one.toml", 'Unknown command "pln". Did you mean "plan"?', "covey --help"),
        ("plan", "FILE: expected a value, got none", "covey plan --help"),
        (
            "plan one.toml --sede 3",
            "Unknown option: --sede. Did you mean --seed?",
            "covey plan --help",
        ),
        (
            "plan one.toml --seed x",
            'Invalid value for --seed: unable to convert "x" into int.',
            "covey plan --help",
        ),
        (
            "draw game.parquet",
            "--output: expected a value, got none",
            "covey draw --help",
        ),
        (
            "draw one.toml -o a.png --view gaem",
            'Invalid value "gaem" for --view. Choose from: "snapshots", "game", "plan", '
            '"tree", "animation". Did you mean "game"?',
            "covey draw --help",
        ),
    ],
)
def test_a_mistake_on_the_command_line_says_where_to_look(line, message, advice, capsys):
    text = refused(capsys, line.split())
    assert text.startswith(message)
    assert text.endswith(f"\nTry: {advice}\n")


def test_a_folder_as_output_is_refused(folder, capsys):
    (folder / "a.parquet").mkdir()
    message = refused(capsys, ["simulate", "one.toml", "-o", "a.parquet"])
    assert message == "a.parquet: expected the name of a file, got a folder\n"
