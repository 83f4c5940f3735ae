"""What comes with covey is loaded by its name; the template explains every key."""

from __future__ import annotations

import re
import tomllib

import pytest

import covey
from covey.scenarios import example_names, example_path
from covey.scenarios.examples import TEMPLATE
from covey.scenarios.schema import ScenarioFile
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PURSUERS
from covey.studies import read_study


def test_a_scenario_is_loaded_by_its_name():
    by_name, by_path = covey.load_scenario("fig3"), covey.load_scenario(example_path("fig3"))
    assert by_name.team.as_rows().tolist() == by_path.team.as_rows().tolist()


def test_a_file_comes_before_a_scenario_of_its_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fig3").write_text("[[team.evaders]]\nposition = [1, 2]\n")
    assert len(covey.load_scenario("fig3").team) == 1


def test_a_study_is_read_by_its_name():
    assert read_study("fig4").starts == 500


@pytest.mark.parametrize(
    ("read", "kind"), [(covey.load_scenario, "scenario"), (read_study, "study")]
)
def test_an_unknown_name_is_told_with_those_that_exist(read, kind):
    known = "everyone, fig3, unc" if kind == "scenario" else "fig4, fig4-assured, fig5, f"
    message = f"figs: no such file, and no {kind} of that name; with covey come {known}"
    with pytest.raises(covey.InputError, match=message):
        read("figs")


def test_the_template_is_no_example():
    assert TEMPLATE.stem not in example_names()


def test_the_template_names_every_key_and_every_strategy():
    text = TEMPLATE.read_text(encoding="utf-8")
    models = ScenarioFile.model_json_schema()["$defs"]
    sections = [model for name, model in models.items() if name.endswith("Section")]
    keys = {key for model in sections for key in model["properties"]}
    assert {"turn_radius", "ago", "side", "time_limit"} < keys
    missing = {key for key in keys if not re.search(rf"\b{key}\b", text)}
    missing |= {name for name in EVADERS | PURSUERS | OBJECTIVES if f'"{name}"' not in text}
    assert missing == set()


def test_the_template_with_its_other_keys_in_place_is_a_scenario_too(tmp_path):
    """Each key behind a comment sign is one that may stand there."""
    lines = TEMPLATE.read_text(encoding="utf-8").splitlines()
    other = [re.sub(r"^# (?=\w+ = |\[)", "", line) for line in lines]
    commented = [after for before, after in zip(lines, other, strict=True) if before != after]
    assert len(commented) > 5
    for line in commented:
        assert isinstance(tomllib.loads(line), dict)
