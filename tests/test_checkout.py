"""The checkout is what the package can be built from, on any system."""

from __future__ import annotations

import re
import subprocess
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.version import Version

from covey.cli import main
from covey.scenarios import load_scenario
from covey.studies import read_study

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))

ADDED_BY_HATCHLING = {"pyproject.toml", "README.md", "LICENSE"}
"""What hatchling reads, it also takes into the source distribution."""

EXTRAS = PROJECT["project"]["optional-dependencies"]
GROUPS = PROJECT["dependency-groups"]
DEVELOP = [
    *PROJECT["build-system"]["requires"],
    *PROJECT["tool"]["hatch"]["metadata"]["hooks"]["custom"]["always"],
    *PROJECT["tool"]["hatch"]["metadata"]["hooks"]["custom"]["compiler"],
    *(each for extra in EXTRAS if extra != "all" for each in EXTRAS[extra]),
    *GROUPS["dev"],
]
ASKED = {
    "develop": DEVELOP,
    "lowest": DEVELOP,
    "docs": GROUPS["docs"],
    "wheel": GROUPS["wheel"],
    "pins": GROUPS["pins"],
}
"""What pyproject.toml asks for, by the file of `requirements/` that has its versions and hashes."""

PIN = re.compile(r"([a-z0-9-]+)==([\w.]+)( ; [^:/@]+)?( --hash=sha256:[0-9a-f]{64})+")


def pins(file):
    """Each version in a file of `requirements/` with its name; fails on any other line."""
    text = (ROOT / "requirements" / f"{file}.txt").read_text(encoding="utf-8")
    assert "://" not in text
    lines = re.sub(r" *\\\n *", " ", text).splitlines()
    found = [PIN.fullmatch(line) or line for line in lines if not line.startswith("#")]
    assert [line for line in found if isinstance(line, str)] == []
    return [(pin[1], Version(pin[2])) for pin in found]


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
    (everything,) = EXTRAS["all"]
    assert set(re.findall(r"\w+", everything)) == {"covey", *EXTRAS} - {"all"}


def test_all_that_is_installed_has_hashes_and_no_address():
    files = {path.stem for path in (ROOT / "requirements").iterdir()}
    assert files == set(ASKED)
    assert all(pins(file) for file in files)


@pytest.mark.parametrize("file", ASKED)
def test_what_is_asked_for_is_pinned_within_its_bounds(file):
    for requirement in map(Requirement, ASKED[file]):
        versions = [version for name, version in pins(file) if name == requirement.name]
        assert versions, f"{requirement}: make pins"
        assert all(version in requirement.specifier for version in versions), f"{requirement}"


def test_the_lowest_versions_that_are_tried_are_the_lowest_that_are_allowed():
    tried = dict(pins("lowest"))
    for requirement in map(Requirement, DEVELOP):
        (bound,) = (each.version for each in requirement.specifier if each.operator == ">=")
        assert tried[requirement.name] == Version(bound), f"{requirement}: make pins"


@pytest.mark.parametrize(
    ("document", "read"),
    [("README.md", load_scenario), ("docs/how-to/studies.md", read_study)],
)
def test_a_file_to_start_from_is_made_as_the_document_says(
    document, read, tmp_path, monkeypatch, capsys
):
    text = (ROOT / document).read_text(encoding="utf-8")
    (line,) = re.findall(r"^covey (new mine.toml|show \S+ > mine.toml)", text, re.MULTILINE)
    command, _, redirected = line.partition(" > ")
    monkeypatch.chdir(tmp_path)
    assert main(command.split()) == 0
    if redirected:
        Path(redirected).write_text(capsys.readouterr().out)
    assert read("mine.toml")
