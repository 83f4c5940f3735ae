"""Results that were changed are refused in one line, and a run plays what is damaged anew."""

from __future__ import annotations

import json
import shutil

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

from covey.model import InputError
from covey.studies import load_study, run_study
from covey.studies.analysis.summary import summary
from covey.studies.running.tables import encoded
from studies.small_studies import files, small_study

STUDY = {"trajectories": True}
TABLES = pytest.mark.parametrize("kind", ["games", "trajectories"])


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """The folder of a study with trajectories that was played from beginning to end."""
    folder = tmp_path_factory.mktemp("undisturbed") / "results"
    result = run_study(small_study(**STUDY), folder, workers=1)
    assert result.is_complete
    assert len(list(folder.glob("trajectories/*"))) == 4
    return folder


@pytest.fixture
def folder(undisturbed, tmp_path):
    """A copy of it, to be damaged."""
    return shutil.copytree(undisturbed, tmp_path / "results")


def damage(path, how):
    content = bytearray(path.read_bytes())
    if how == "gone":
        path.unlink()
    elif how == "empty":
        path.write_bytes(b"")
    elif how == "cut":
        path.write_bytes(content[:-10])
    elif how == "bit":
        content[len(content) // 3] ^= 16
        path.write_bytes(content)
    elif how == "not UTF-8":
        path.write_bytes(content.replace(b"game", b"\x80ame"))
    elif how == "of other games":
        shutil.copyfile(path.with_name("part-00000.parquet"), path)
    else:
        table = pq.read_table(path)
        games = table["game"].to_numpy()
        path.write_bytes(encoded(table.filter(pa.array(games < games[-1]))))


@TABLES
@pytest.mark.parametrize(
    "how", ["gone", "empty", "cut", "bit", "not UTF-8", "of other games", "a game less"]
)
def test_a_damaged_part_is_played_anew(folder, undisturbed, kind, how):
    part = folder / kind / "part-00002.parquet"
    kept = {path: path.stat().st_mtime_ns for path in folder.glob("*/*") if path.name != part.name}
    damage(part, how)
    calls = []
    result = run_study(
        small_study(**STUDY), folder, workers=1, progress=lambda *done: calls.append(done)
    )
    assert (calls[0], calls[-1]) == ((136, 200), (200, 200))
    assert result.is_complete
    assert files(folder) == files(undisturbed)
    assert {path: path.stat().st_mtime_ns for path in kept} == kept


@TABLES
def test_a_study_without_a_part_is_not_complete(folder, kind):
    assert load_study(folder).is_complete
    (folder / kind / "part-00001.parquet").unlink()
    assert not load_study(folder).is_complete


CHANGES = {
    "game": -1,
    "start": 99,
    "case": 99,
    "team_size": 9,
    "guarantee": np.nan,
    "survival_time": 0.0,
    "value": np.inf,
    "captured_0": 7,
    "captured_1": 0,
    "capture_time_0": 1e9,
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_game_that_contradicts_itself_is_refused_and_played_anew(folder, undisturbed, name):
    part = folder / "games" / "part-00001.parquet"
    table = pq.read_table(part)
    assert table["captured_0"][3].as_py() == 0
    column = table[name].to_numpy().copy()
    column[3] = CHANGES[name]
    at, field = table.column_names.index(name), table.schema.field(name)
    part.write_bytes(encoded(table.set_column(at, field, pa.array(column, field.type))))
    with pytest.raises(InputError, match=r"part-00001\.parquet: the part is damaged: expected "):
        summary(load_study(folder))
    run_study(small_study(**STUDY), folder, workers=1)
    assert files(folder) == files(undisturbed)


def test_tables_from_before_there_were_objectives_are_read(folder):
    expected = summary(load_study(folder))
    for part in folder.glob("games/*"):
        table = pq.read_table(part)
        pq.write_table(table.drop_columns(["objective", "planned_value", "value"]), part)
    manifest = json.loads((folder / "manifest.json").read_text())
    del manifest["study"]["grid"]["objective"]
    (folder / "manifest.json").write_text(json.dumps(manifest))
    assert summary(load_study(folder)) == expected


def leaves(tree, path=()):
    """The paths of everything in nested tables and lists."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, value in items:
        yield (*path, key)
        if isinstance(value, dict | list) and value:
            yield from leaves(value, (*path, key))


@st.composite
def manifests(draw, manifest):
    """A manifest in which one thing was changed or left out."""
    *path, key = draw(st.sampled_from(list(leaves(manifest))))
    parent = manifest
    for step in path:
        parent = parent[step]
    nasty = [None, True, -1, 0, 1, 99, 0.5, 1e308, float("nan"), "", "x", [], {}, [0.0], [{}]]
    if draw(st.booleans()):
        parent[key] = draw(st.sampled_from(nasty))
    else:
        del parent[key]
    return manifest


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    """The folder of a study of twelve games, and its manifest."""
    folder = tmp_path_factory.mktemp("tiny") / "results"
    run_study(small_study(starts=3, evaders=["open-loop", "hold-course"]), folder, workers=1)
    return folder, (folder / "manifest.json").read_text()


@given(data=st.data())
def test_a_changed_manifest_is_refused_or_summed_up(tiny, data):
    folder, manifest = tiny
    changed = data.draw(manifests(json.loads(manifest)))
    (folder / "manifest.json").write_text(json.dumps(changed))
    lines = []
    try:
        lines = summary(load_study(folder))
    except InputError as error:
        said = str(error)
    else:
        said = ""
    assert "\n" not in said
    assert bool(lines) != bool(said)


@pytest.mark.parametrize("content", ["", "[]", "3", "{", "[" * 100_000, '{"format": 2}'])
def test_what_is_no_manifest_is_refused(folder, content):
    (folder / "manifest.json").write_text(content)
    with pytest.raises(InputError, match=r"manifest\.json: expected the manifest of a study"):
        load_study(folder)
