"""The JSON schema accepts every file that comes along, and rejects what it can say is wrong."""

from __future__ import annotations

import json
import tomllib

import jsonschema
import pytest

from covey import scenarios, studies
from covey.cli import main
from covey.scenarios.examples import TEMPLATE
from covey.scenarios.json_schema import json_schema
from covey.scenarios.schema import ScenarioFile
from covey.studies.design.study_file import StudyFile
from scenarios import test_mistakes_of_other_tables as of_other_tables
from scenarios import test_mistakes_of_the_team as of_the_team
from scenarios.scenario_files import ONE_EVADER

BEYOND_A_SCHEMA = ("slower than the pursuer", "at the centre of the pursuer's disk", "nan")
"""What must fit together, and what no number of JSON is."""


SCHEMAS = {
    "scenario": json_schema(ScenarioFile, "A scenario of covey"),
    "study": json_schema(StudyFile, "A study of covey"),
}


def errors(kind, text):
    """What an editor shows of a text in TOML."""
    validator = jsonschema.Draft202012Validator(SCHEMAS[kind])
    return list(validator.iter_errors(tomllib.loads(text)))


@pytest.mark.parametrize("kind", SCHEMAS)
def test_the_command_prints_a_schema(kind, capsys):
    assert main(["schema", kind]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed == SCHEMAS[kind]
    jsonschema.Draft202012Validator.check_schema(printed)


@pytest.mark.parametrize(
    ("kind", "path"),
    [
        *(("scenario", scenarios.example_path(name)) for name in scenarios.example_names()),
        ("scenario", TEMPLATE),
        *(("study", studies.example_path(name)) for name in studies.example_names()),
    ],
    ids=str,
)
def test_a_file_that_comes_along_is_accepted(kind, path):
    assert errors(kind, path.read_text(encoding="utf-8")) == []


def mistaken(test):
    """The files of a test of mistakes whose mistake a schema can say."""
    (mark,) = test.pytestmark
    return [
        text for text, line in mark.args[1] if not any(each in line for each in BEYOND_A_SCHEMA)
    ]


@pytest.mark.parametrize("text", mistaken(of_the_team.test_a_mistake_of_an_evader))
def test_a_mistake_of_an_evader_is_rejected(text):
    assert errors("scenario", f"[[team.evaders]]\n{text}\n")


@pytest.mark.parametrize("text", mistaken(of_other_tables.test_a_mistake_of_the_rest))
def test_a_mistake_of_the_rest_is_rejected(text):
    assert errors("scenario", f"{text}\n{ONE_EVADER}")


@pytest.mark.parametrize(
    "text",
    [
        "[team]\nevaders = []",
        "[team.random]\ncount = 51",
        "[team.random]\ncount = 2.5",
        "team = 3",
        "",
        "[[team.evaders]]\nposition = [1, 2]\n" * 51,
        '[team]\nstrategy = "opn-loop"\n[team.random]\ncount = 3',
        '[team]\nstrategy = { name = "open-loop", starts = 0 }\n[team.random]\ncount = 3',
        '[pursuer]\nstrategy = { name = "committed", margn = 0.1 }\n[team.random]\ncount = 3',
        "[team]\nturn_rate = 1\nturn_radius = 1\n[team.random]\ncount = 3",
        "[team.random]\ncount = 3\n"
        "[pursuer]\nradius = 1\nlast_seen = { position = [0, 0], ago = 1 }",
    ],
)
def test_a_mistake_of_the_whole_is_rejected(text):
    assert errors("scenario", text)


@pytest.mark.parametrize(
    "text",
    [
        "starts = 0",
        "startz = 3",
        "[grid]\nteam_size = [2, 51]",
        "[grid]\nteam_size = [2, 2]",
        "[grid]\nspeed = []",
        '[grid]\nsensing = "seen"',
        '[grid]\npursuer = ["committed", "careless"]',
        'sampler = { name = "square", side = -1 }',
    ],
)
def test_a_mistake_of_a_study_is_rejected(text):
    assert errors("study", text)


@pytest.mark.parametrize("kind", SCHEMAS)
def test_each_key_says_what_it_means_and_has_an_example_that_is_accepted(kind):
    schema = SCHEMAS[kind]
    for table in (schema, *schema["$defs"].values()):
        for name, key in table["properties"].items():
            if name != "name":  # of a strategy, which the table of strategies tells
                assert key["x-meaning"].endswith(".")
                validator = jsonschema.Draft202012Validator({**key, "$defs": schema["$defs"]})
                assert list(validator.iter_errors(key["examples"][0])) == []
