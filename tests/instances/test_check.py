"""Every number that is known about a small game is computed again, and a changed one is found."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

import covey
from covey.instances import files
from covey.instances.check import check
from covey.instances.improve import improve
from covey.instances.load import load_instance

SMALL = [name for name in files.instance_names() if int(name.split("-")[-1]) <= 4]
NUMBER = re.compile(r"-?\d+\.\d+(?:e-?\d+)?")
SEQUENCES = ("worst_sequence", "sequence")


def lines_of(name):
    return files.values_path(name).read_text("utf-8").splitlines()


@pytest.fixture
def copy(tmp_path, monkeypatch):
    """A copy of the set that a test may change."""
    for part in ("games", "values"):
        shutil.copytree(Path(files.__file__).parent / part, tmp_path / part)
    monkeypatch.setattr(files, "_FOLDER", tmp_path)
    return tmp_path / "values"


@pytest.mark.parametrize("name", SMALL)
def test_every_number_of_a_small_game_holds(name):
    assert check(load_instance(name), 60.0) == ([], [])


def changed(line):
    """The line with each of its numbers a little larger, one at a time."""
    for number in NUMBER.finditer(line):
        larger = repr(float(number[0]) * (1.0 + 1e-5) + 1e-300)
        if float(larger) != float(number[0]):
            yield f"{line[: number.start()]}{larger}{line[number.end() :]}"


CHANGES = [
    pytest.param(name, k, other, id=f"{name}: {other.strip()}")
    for name in ("disk-2", "simple-2")
    for k, line in enumerate(lines_of(name))
    for other in changed(line)
]


@pytest.mark.parametrize(("name", "k", "other"), CHANGES)
def test_a_number_that_was_changed_is_found(copy, name, k, other):
    lines = lines_of(name)
    lines[k] = other
    (copy / f"{name}.toml").write_text("\n".join([*lines, ""]), "utf-8")
    assert check(load_instance(name), 60.0).mistakes


@pytest.mark.parametrize("key", SEQUENCES)
def test_a_sequence_that_was_changed_is_found(copy, key):
    text = "\n".join(lines_of("disk-2"))
    swapped = re.sub(rf"^{key} = \[(\d), (\d)\]", rf"{key} = [\2, \1]", text, flags=re.MULTILINE)
    assert swapped != text
    (copy / "disk-2.toml").write_text(f"{swapped}\n", "utf-8")
    assert check(load_instance("disk-2"), 60.0).mistakes


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("exact = true", "exact = false", "expected the line `exact = true`"),
        ("depth = 2", "depth = 1", "lower: is "),
        ("with their turn rates", "that turn at once", "upper_by: expected announced"),
    ],
)
def test_a_statement_that_was_changed_is_found(copy, old, new, said):
    text = "\n".join(lines_of("mixed-3"))
    if "turn rates" in old:
        name = next(n for n in SMALL if old in "\n".join(lines_of(n)))
        text = "\n".join(lines_of(name))
    else:
        name = "mixed-3"
    lines = text.splitlines()
    where = max(k for k, line in enumerate(lines) if old in line)
    lines[where] = lines[where].replace(old, new)
    (copy / f"{name}.toml").write_text("\n".join([*lines, ""]), "utf-8")
    assert any(said in mistake for mistake in check(load_instance(name), 60.0).mistakes)


def test_a_guarantee_that_no_time_is_left_for_is_called_undecided():
    game = covey.load_instance("paper-20")
    found = check(game, 0.0)
    assert found.mistakes == []
    assert re.match("survival_time: .* was proven within 0 s", found.undecided[0])


def test_a_search_improves_a_worse_plan_and_keeps_a_better_one(copy):
    best = load_instance("mixed-3").plan
    path = copy / "mixed-3.toml"
    path.unlink()
    assert improve("mixed-3", 0.2, seed=0, bounds=False)
    found = load_instance("mixed-3")
    assert found.plan.survival_time == pytest.approx(best.survival_time, rel=1e-6)
    assert check(found, 60.0).mistakes == []
    text = path.read_text("utf-8")
    assert not improve("mixed-3", 0.0, seed=0, bounds=True)
    assert path.read_text("utf-8") == text
