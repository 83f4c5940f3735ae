"""Every number that is known about a small game is computed again, and a changed one is found."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

import covey
from covey.instances import files
from covey.instances.check import check
from covey.instances.improve import improve, main
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
    ("name", "old", "new", "said"),
    [
        ("mixed-3", "exact = true", "exact = false", "expected the line `exact = true`"),
        ("mixed-3", "depth = 2", "depth = 0", "lower: is "),
        ("mixed-3", "that turn at once", "with their turn rates", "upper_by: expected announced"),
    ],
)
def test_a_statement_that_was_changed_is_found(copy, name, old, new, said):
    path = copy / f"{name}.toml"
    assert old in path.read_text("utf-8")
    path.write_text(path.read_text("utf-8").replace(old, new), "utf-8")
    assert any(said in mistake for mistake in check(load_instance(name), 60.0).mistakes)


@pytest.mark.parametrize(
    ("below", "above", "mistakes", "undecided"),
    [
        (0.9, 1.0, 0, 1),  # less was proven in the time
        (0.8, 0.9, 1, 0),  # another sequence is worse
        (1.1, 1.2, 1, 0),  # more is guaranteed
    ],
)
def test_a_guarantee_is_wrong_only_if_it_is_refuted(below, above, mistakes, undecided, monkeypatch):
    game = covey.load_instance("disk-2")
    time, sequence = game.plan.survival_time, game.plan.worst_sequence

    def proven_in_time(team, disk, turns, time_limit):
        return covey.Guarantee(below * time, sequence, above * time)

    monkeypatch.setattr("covey.instances.check.guaranteed_survival", proven_in_time)
    assert tuple(map(len, check(game, 3.0))) == (mistakes, undecided)


def test_a_search_improves_a_worse_plan_and_keeps_a_better_one(copy):
    best = load_instance("mixed-3").plan
    path = copy / "mixed-3.toml"
    path.unlink()
    assert improve("mixed-3", 0.2, seed=0)
    found = load_instance("mixed-3")
    assert found.plan.survival_time == pytest.approx(best.survival_time, rel=1e-6)
    assert check(found, 60.0).mistakes == []
    text = path.read_text("utf-8")
    assert not improve("mixed-3", 0.0, seed=0, bounds=True)
    assert path.read_text("utf-8") == text


def test_a_plan_of_ones_own_is_taken_only_if_it_guarantees_more(copy, tmp_path, capsys):
    path, mine = copy / "mixed-3.toml", tmp_path / "mine.txt"
    text, turns = path.read_text("utf-8"), load_instance("mixed-3").plan.turns
    words = ["mixed-3", "--seconds", "0", "--turns", str(mine)]
    mine.write_text("0.1\n0.2\n-0.3\n")
    main(words)
    assert path.read_text("utf-8") == text
    path.unlink()
    main(words)
    worse = load_instance("mixed-3").plan
    assert worse.turns.tolist() == [0.1, 0.2, -0.3]
    mine.write_text("\n".join(map(repr, turns.tolist())))
    main(words)
    assert load_instance("mixed-3").plan.turns.tolist() == turns.tolist()
    assert [line.endswith("better") for line in capsys.readouterr().out.splitlines()] == [
        False,
        True,
        True,
    ]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["circle-31"], 'did you mean "circle-30"?'),
        (["mixed-3", "--turns", "no.txt"], "no.txt: expected a number in each line"),
        (["mixed-3", "--turns", "two.txt"], "turns: expected an array of shape (3,)"),
        (["paper-2", "--turns", "two.txt"], "turns: expected turns in [-π, π]"),
    ],
)
def test_a_mistake_in_a_search_is_told(words, said, copy, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "two.txt").write_text("0.1\n4.0\n")
    with pytest.raises(SystemExit, match="2"):
        main(words)
    assert said in capsys.readouterr().err
