"""What is made of a study of several objectives: scores, table, picture."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import covey
from covey.cli import main
from covey.studies import Study, example_path, read_study, run_study
from covey.studies.analysis.comparison import comparison
from covey.studies.analysis.objectives import MEASURES, compares_objectives

SMALL = """
starts = 4
[grid]
team_size = [1, 3]
update_time = 0.2
sensing = "hidden"
objective = ["last-capture", "total-survival", "expected-survival"]
pursuer = ["committed", "random-sequence"]
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("objectives")
    (place / "small.toml").write_text(SMALL)
    run_study(place / "small.toml", place / "results", workers=1)
    return place


def test_the_study_that_comes_with_covey_compares_all():
    study = read_study(example_path("objectives"))
    assert compares_objectives(study.describe())
    assert {each.describe()["name"] for each in study.objective} == {
        "last-capture",
        "total-survival",
        "expected-survival",
    }


def test_scores_are_ratios_of_what_the_table_holds(folder):
    result = covey.load_study(folder / "results")
    compared = comparison(result)
    games = result.to_pandas()
    assert compared.base == "last capture"
    assert {score.column for score in compared.ratios} == set(MEASURES)
    chosen = games[(games["team_size"] == 3) & (games["pursuer"] == "random-sequence")]
    times = chosen[[f"capture_time_{k}" for k in range(3)]]
    own, first = (times[chosen["objective"] == name] for name in ("total-survival", "last-capture"))
    wanted = {
        "first capture": own["capture_time_0"].mean() / first["capture_time_0"].mean(),
        "mean survival": own.to_numpy().mean() / first.to_numpy().mean(),
        "last capture": own["capture_time_2"].mean() / first["capture_time_2"].mean(),
    }
    found = {
        score.column: score.relative.value
        for score in compared.ratios
        if score.group == "hidden pursuer, random-sequence"
        and (score.row, score.team_size) == ("sum", 3)
    }
    assert found == pytest.approx(wanted, rel=1e-12)


def test_one_evader_alone_makes_no_difference(folder):
    compared = comparison(covey.load_study(folder / "results"))
    alone = [score.relative.value for score in compared.ratios if score.team_size == 1]
    assert alone == pytest.approx([1.0] * len(alone), rel=1e-5)


def test_its_tables_are_printed_and_its_picture_drawn(folder, tmp_path, capsys):
    arguments = ["study", str(folder / "small.toml"), "--output", str(folder / "results")]
    assert main(arguments) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "hidden pursuer, committed" in told
    assert "expected sum" in told
    assert "Mean, relative to games about the last capture, from the same 4 starts" in told
    assert main([*arguments, "--json"]) == 0
    cases = json.loads(capsys.readouterr().out)["cases"]
    assert all(math.isfinite(case["value"]["value"]) for case in cases)
    picture = tmp_path / "small.png"
    assert main(["draw", str(folder / "results"), "--output", str(picture)]) == 0
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_a_plain_study_of_sums_tells_their_mean(tmp_path, capsys):
    (several,) = [line for line in SMALL.splitlines() if line.startswith("objective")]
    text = SMALL.replace(several, 'objective = "total-survival"')
    (tmp_path / "plain.toml").write_text(text)
    arguments = ["study", str(tmp_path / "plain.toml"), "--output", str(tmp_path / "results")]
    assert main(arguments) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "Value: what came of the objective." in told
    values = covey.load_study(tmp_path / "results").games["value"].to_numpy()
    mean = np.mean(values.reshape(4, -1)[:, -1])
    assert f"{mean:.4f}" in told


def test_results_of_a_time_before_objectives_are_read(tmp_path):
    run_study(Study(starts=2, update_time=0.2, team_size=2), tmp_path, workers=1)
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    del manifest["study"]["grid"]["objective"]
    (tmp_path / "manifest.json").write_text(json.dumps(manifest))
    result = covey.load_study(tmp_path)
    assert result.study["grid"]["objective"] == [{"name": "last-capture"}]
    assert comparison(result) is None
