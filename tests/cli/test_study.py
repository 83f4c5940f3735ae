"""What `covey study` prints and writes, and what `covey reproduce` makes of the paper's studies."""

from __future__ import annotations

import json

import pytest

import covey
from covey.cli import main
from covey.studies.running.games import play_start

SMALL = """
starts = 20
[grid]
team_size = [2, 3]
update_time = 0.1
turn_rate = [1.0, 2.0]
sensing = "hidden"
"""


@pytest.fixture
def file(tmp_path, monkeypatch):
    """A small study in an empty working folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "small.toml").write_text(SMALL)
    return tmp_path / "small.toml"


def test_a_study_is_played_and_summed_up(file, capsys):
    assert main(["study", "small.toml", "--workers", "1"]) == 0
    output = capsys.readouterr()
    assert "turn rate" in output.out
    assert "Means over 20 starts" in output.out
    assert "sensing" not in output.out  # it is the same in all cases
    assert covey.load_study("results/small").is_complete


def test_angles_are_shown_as_they_were_typed(file, capsys):
    file.write_text(SMALL.replace("[1.0, 2.0]", '["10 deg", "pi/2", 1.0]').replace("20", "1"))
    for _ in range(2):  # the second time from the results that are there
        assert main(["study", "small.toml", "--workers", "1"]) == 0
        shown = capsys.readouterr().out
        assert all(text in shown for text in ("10 deg", "pi/2", "Means over 1 start,"))
        assert "0.17" not in shown
        assert "nan" not in shown
    file.write_text(file.read_text().replace("10 deg", "20 deg"))
    assert main(["study", "small.toml", "--workers", "1"]) == 2
    assert (
        'grid.turn_rate: is ["10 deg", "pi/2", "1.0"] there, and ["20 deg", "pi/2", "1.0"] now'
        in capsys.readouterr().err
    )


def test_numbers_are_shown_with_the_units_of_the_file(file, capsys):
    file.write_text('unit = "km"\n' + SMALL.replace("starts = 20", "starts = 1"))
    assert main(["study", "small.toml", "--workers", "1"]) == 0
    shown = capsys.readouterr().out
    for heading in ("turn rate (rad/s)", "guaranteed (s)", "survival time (s)"):
        assert heading in shown
    file.write_text(SMALL.replace("[1.0, 2.0]", '["10 deg", "20 deg"]'))
    assert main(["study", "small.toml", "--workers", "1", "--output", "degrees"]) == 0
    assert "rad" not in capsys.readouterr().out


def test_no_number_is_cut_off_where_the_names_of_strategies_are_long(file, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    teams = '["iterative-open-loop", "contingent"]'
    file.write_text(SMALL.replace("20", "2").replace("sensing", f"evaders = {teams}\nsensing"))
    assert main(["study", "small.toml", "--workers", "1"]) == 0
    shown = capsys.readouterr().out
    assert "contingent" in shown
    assert "…" not in shown
    assert "replan" not in shown  # the names tell the teams apart


def test_json_has_all_digits(file, capsys):
    assert main(["study", "small.toml", "--workers", "1", "--output", "there", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["games"] == 80
    assert told["complete"]
    times = covey.load_study("there").games["survival_time"].to_numpy().reshape(20, 4)
    assert [case["survival_time"]["value"] for case in told["cases"]] == pytest.approx(
        times.mean(axis=0).tolist(), rel=1e-14
    )
    assert [case["turn_rate"] for case in told["cases"]] == [1.0, 2.0, 1.0, 2.0]


def test_another_study_in_the_folder_is_refused(file, capsys):
    assert main(["study", "small.toml", "--workers", "1"]) == 0
    file.write_text(SMALL.replace("20", "30"))
    assert main(["study", "small.toml", "--workers", "1"]) == 2
    assert "starts: is 20 there, and 30 now" in capsys.readouterr().err


def test_the_mistakes_of_a_file_are_told(file, capsys):
    file.write_text("startz = 3\n[grid]\nspeed = -1\n")
    assert main(["study", "small.toml"]) == 2
    error = capsys.readouterr().err
    assert 'startz: unknown key; did you mean "starts"?' in error
    assert "grid.speed: expected a finite number >= 0, got -1" in error


def test_a_study_that_comes_with_covey_is_meant(capsys):
    assert main(["study", "fig6"]) == 2
    assert "no study of that name" in capsys.readouterr().err


@pytest.fixture
def broken(monkeypatch):
    """No game with start 0 can be played."""

    def play(study, start):
        if start == 0:
            raise ZeroDivisionError("no heading")
        return play_start(study, start)

    monkeypatch.setattr("covey.studies.running.worker.play_start", play)


def test_no_games_are_lost_silently(file, broken, capsys):
    assert main(["study", "small.toml", "--workers", "1"]) == 3
    output = capsys.readouterr()
    assert "Means over 4 starts" in output.out
    head, line = output.err.splitlines()[-2:]
    assert head == ("covey: results/small: games are missing; run the study again to try them anew")
    assert line.startswith("  starts 0 to 15 are missing: start 0 (seed ")


def test_no_games_are_lost_silently_in_json(file, broken, capsys):
    assert main(["study", "small.toml", "--workers", "1", "--json"]) == 3
    output = capsys.readouterr()
    told = json.loads(output.out)
    assert not told["complete"]
    assert [line.partition(":")[0] for line in told["failures"]] == ["starts 0 to 15 are missing"]
    assert {case["starts"] for case in told["cases"]} == {4}
    assert "games are missing; run the study again" in output.err


def test_the_paper_is_not_reproduced_without_all_games(tmp_path, broken, monkeypatch, capsys):
    monkeypatch.setattr("covey.cli.commands.reproduce._reproduce_game", lambda folder: None)
    assert main(["reproduce", "-o", str(tmp_path), "--starts", "2", "--workers", "1"]) == 3
    assert "fig4: games are missing; run the study again" in capsys.readouterr().err
    assert not (tmp_path / "report.md").exists()


def test_the_paper_is_reproduced_with_a_report(tmp_path, capsys):
    starts = ["--starts", "6", "--contingent-starts", "2"]
    assert main(["reproduce", "--output", str(tmp_path), *starts, "--workers", "1"]) == 0
    there = {path.name for path in tmp_path.iterdir()}
    figures = {f"fig{k}.{ending}" for k in range(1, 6) for ending in ("png", "svg", "pdf")}
    folders = {"fig4", "fig4-assured", "fig5", "fig5-contingent"}
    assert figures | folders | {"report.md", "fig3.gif", "fig4.csv", "fig5.csv"} <= there
    report = (tmp_path / "report.md").read_text()
    assert "272 games from 6 starts" in report
    assert "from the same 2 starts" in report
    assert report.count("| assured | 6 |") == 2
    for claim in ("200 of 500", "Larger teams gain more", "Where the definitions differ"):
        assert claim in report
    assert report.count("**holds") + report.count("**differs**") == 8
