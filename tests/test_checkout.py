"""The checkout is what the package can be built from, on any system."""

from __future__ import annotations

import re
import subprocess
import tomllib
from pathlib import Path

import pytest

from covey.scenarios import load_scenario
from covey.studies import read_study

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))

ADDED_BY_HATCHLING = {"pyproject.toml", "README.md", "LICENSE"}
"""What hatchling reads, it also takes into the source distribution."""


@pytest.fixture(scope="module")
def tracked():
    """The paths that git tracks, by their modes."""
    if not (ROOT / ".git").exists():
        pytest.skip("not a checkout: git doesn't say what belongs to it")
    command = ["git", "-C", str(ROOT), "ls-files", "--stage", "-z"]
    listed = subprocess.run(command, capture_output=True, encoding="utf-8", check=True).stdout
    lines = (line.split("\t") for line in listed.split("\0") if line)
    return {path: stage.split()[0] for stage, path in lines}


def test_no_file_is_a_symbolic_link(tracked):
    assert [path for path, mode in tracked.items() if mode == "120000"] == []


def test_the_source_distribution_has_all_but_hidden_files(tracked):
    listed = set(PROJECT["tool"]["hatch"]["build"]["targets"]["sdist"]["only-include"])
    top = {path.split("/")[0] for path in tracked}
    assert {name for name in top if name[0] != "."} == listed | ADDED_BY_HATCHLING


def test_the_extra_all_has_all_that_users_need():
    extras = PROJECT["project"]["optional-dependencies"]
    (everything,) = extras["all"]
    assert set(re.findall(r"\w+", everything)) == {"covey", *extras} - {"all"}


@pytest.mark.parametrize(
    ("document", "read"),
    [("README.md", load_scenario), ("docs/how-to/studies.md", read_study)],
)
def test_a_file_that_comes_with_covey_is_copied_as_the_document_says(
    document, read, tmp_path, monkeypatch
):
    text = (ROOT / document).read_text(encoding="utf-8")
    (program,) = re.findall(r'^python -c "(.*)"$', text, re.MULTILINE)
    monkeypatch.chdir(tmp_path)
    exec(program, {})
    assert read("mine.toml")
