"""The record of a game goes to a Parquet file and comes back without loss, or not at all."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import random
from contextlib import suppress

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from covey.simulation.files import check_writable, whole_file
from covey.simulation.storage import FORMAT, _checksum, is_parquet
from random_games import extent, games


def identical(one, other):
    """Equal to the last bit, types and shapes included."""
    if dataclasses.is_dataclass(one):
        return type(one) is type(other) and all(
            identical(getattr(one, field.name), getattr(other, field.name))
            for field in dataclasses.fields(one)
        )
    if isinstance(one, np.ndarray):
        return (one.dtype, one.shape, one.tobytes()) == (other.dtype, other.shape, other.tobytes())
    return type(one) is type(other) and one == other


_parameters = st.dictionaries(
    st.sampled_from(["margin", "starts", "sequence", "note"]),
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False)
    | st.text()
    | st.lists(st.integers(-1, 5)),
)


@st.composite
def records(draw):
    """Records of any game in any unit, of strategies with any parameters."""
    team, disk, _ = draw(games())
    step = (extent(team, disk) or 1.0) / disk.speed
    game = covey.simulate(team, disk, evaders=covey.HoldCourse(), update_time=step)
    return dataclasses.replace(
        game,
        seed=draw(st.integers(0, 2**80)),
        objective={"name": "any", **draw(_parameters)},
        strategies={side: {"name": side, **draw(_parameters)} for side in ("evaders", "pursuer")},
    )


@pytest.fixture(scope="module")
def game():
    team = covey.Team([[0.3, 0.1], [-0.2, 0.3]], [0.3, 2.2], 0.25, [math.inf, 1.0])
    return covey.simulate(team, covey.PursuerDisk(), update_time=0.1)


@pytest.fixture
def saved(game, tmp_path):
    path = tmp_path / "game.parquet"
    covey.save_game(game, path)
    return path


@settings(max_examples=50)
@given(record=records())
def test_a_record_comes_back_to_the_last_bit(record, tmp_path_factory):
    path = tmp_path_factory.getbasetemp() / "any.parquet"
    covey.save_game(record, path)
    assert identical(covey.load_game(path), record)


def test_a_played_game_comes_back_to_the_last_bit(game, saved):
    assert identical(covey.load_game(saved), game)


def test_a_game_stopped_by_its_time_limit_comes_back(tmp_path):
    team = covey.Team([[0.3, 0.1], [-0.2, 0.3]], [0.3, 2.2])
    game = covey.simulate(team, covey.PursuerDisk(), update_time=0.1, time_limit=0.2)
    covey.save_game(game, tmp_path / "game.parquet")
    back = covey.load_game(tmp_path / "game.parquet")
    assert (back.survival_time, back.status) == (math.inf, covey.GameStatus.TIME_LIMIT)
    assert identical(back, game)


def test_parameters_of_any_strategy_are_kept_as_well_as_json_can(game, tmp_path):
    own = {"name": "Mine", "gains": np.array([1.0, math.inf]), "pair": (1, 2), "call": len, 3: None}
    path = tmp_path / "game.parquet"
    covey.save_game(dataclasses.replace(game, strategies={"evaders": own, "pursuer": {}}), path)
    assert covey.load_game(path).strategies == {
        "evaders": {
            "name": "Mine",
            "gains": [1.0, math.inf],
            "pair": [1, 2],
            "call": repr(len),
            "3": None,
        },
        "pursuer": {},
    }


def test_other_readers_find_one_number_a_column_and_strict_json(game, saved):
    table = pd.read_parquet(saved)
    assert len(table) == len(game.times)
    assert set(table.dtypes.astype(str)) == {"float64", "int64"}
    assert table["evader_1_y"].tolist() == game.evader_positions[:, 1, 1].tolist()
    assert table["critical_sequence_0"].tolist() == game.critical_sequences[:, 0].tolist()
    header = pq.read_schema(saved).metadata[b"covey"]
    told = json.loads(header, parse_constant=lambda name: pytest.fail(f"{name} is no JSON"))
    assert told["format"] == FORMAT
    assert told["team"]["turn_rates"] == [{"float": "inf"}, 1.0]


def test_a_file_is_replaced(game, tmp_path):
    path = tmp_path / "game.parquet"
    covey.save_game(game, path)
    covey.save_game(dataclasses.replace(game, seed=5), path)
    assert covey.load_game(path).seed == 5
    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_folder_is_not_made_but_told(game, tmp_path):
    folder = tmp_path / "new" / "folder"
    with pytest.raises(FileNotFoundError, match="can't be written: there is no folder") as caught:
        covey.save_game(game, folder / "game.parquet")
    assert caught.value.strerror.endswith(f"{folder}; make it first: mkdir -p {folder}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["a" * 300, "none/a", "file/a"])
def test_what_cannot_be_written_is_known_before(name, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    path = tmp_path / name
    with pytest.raises(OSError, match="can't be written: ") as before:
        check_writable(path)
    with pytest.raises(OSError, match="can't be written: ") as then, whole_file(path):
        pass
    assert str(before.value) == str(then.value)


def test_the_check_leaves_nothing(tmp_path):
    (tmp_path / "there").write_bytes(b"old")
    for name in ("there", "new"):
        check_writable(tmp_path / name)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"there": b"old"}


def test_a_new_file_may_be_read_by_whom_the_user_lets(tmp_path):
    plain = tmp_path / "plain"
    plain.write_bytes(b"")
    with whole_file(tmp_path / "whole") as file:
        file.write(b"all of it")
    assert (tmp_path / "whole").stat().st_mode == plain.stat().st_mode


@pytest.mark.parametrize("interruption", [RuntimeError, KeyboardInterrupt])
def test_a_broken_write_leaves_the_old_file_and_nothing_else(interruption, tmp_path):
    path = tmp_path / "kept"
    path.write_bytes(b"old")

    def write_half():
        with whole_file(path) as file:
            file.write(b"half of the n")
            raise interruption

    with pytest.raises(interruption):
        write_half()
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_folder_that_is_a_file_is_named(game, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    path = tmp_path / "file" / "game.parquet"
    with pytest.raises(OSError, match="can't be written") as caught:
        covey.save_game(game, path)
    assert caught.value.filename == str(path)


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="chmod doesn't lock folders on Windows")
@pytest.mark.skipif("os.geteuid() == 0", reason="the superuser may write everywhere")
def test_a_folder_that_may_not_be_written_to_is_named(game, tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(PermissionError, match=r"can't be written: Permission denied.*game"):
        covey.save_game(game, tmp_path / "game.parquet")


def test_what_was_saved_is_parquet(saved, tmp_path):
    assert is_parquet(saved)
    assert not is_parquet(tmp_path)
    assert not is_parquet(tmp_path / "none")


def refused(path):
    """The message with which a file is refused; it begins with the file's name."""
    with pytest.raises(covey.InputError) as caught:
        covey.load_game(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    return message.removeprefix(f"{path}: ")


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    assert refused(tmp_path / "none.parquet") == "can't be read: No such file or directory"
    assert refused(tmp_path).startswith("can't be read: ")


@pytest.mark.parametrize("content", [b"", b"PAR", b"time,x\n0,1\n", bytes(range(256))])
def test_a_file_of_something_else_is_refused(content, tmp_path):
    path = tmp_path / "game.parquet"
    path.write_bytes(content)
    assert refused(path) == "expected the record of a game, got a file that isn't Parquet"


def test_another_table_is_refused(tmp_path):
    path = tmp_path / "other.parquet"
    pq.write_table(pa.table({"time": [0.0, 1.0]}), path)
    assert refused(path) == "expected the record of a game, got a Parquet file of something else"


@pytest.mark.parametrize("unknown", [FORMAT + 1, 0, "1", None])
def test_an_unknown_format_is_refused_with_what_to_do(unknown, saved):
    table = pq.read_table(saved)
    header = json.loads(table.schema.metadata[b"covey"])
    header |= {"format": unknown, "version": "99.0"}
    pq.write_table(table.replace_schema_metadata({b"covey": json.dumps(header)}), saved)
    message = refused(saved)
    assert message.startswith(
        f"written by covey '99.0' in record format {unknown!r}, and this covey"
    )
    assert message.endswith(f" reads format {FORMAT}; use that covey, or simulate anew")


def test_a_record_from_before_there_were_objectives_is_read(game, saved):
    table = pq.read_table(saved)
    header = json.loads(table.schema.metadata[b"covey"])
    for added in ("objective", "planned_value", "value"):
        del header[added]
    note = json.dumps(header).encode()
    notes = {b"covey": note, b"covey_crc32": _checksum(note, table)}
    pq.write_table(table.replace_schema_metadata(notes), saved)
    assert identical(covey.load_game(saved), game)


@pytest.mark.parametrize("change", ["without checksum", "without time", "header is a list"])
def test_a_record_that_lacks_something_is_damaged(change, saved):
    table = pq.read_table(saved)
    notes = table.schema.metadata
    if change == "without checksum":
        notes = {b"covey": notes[b"covey"]}
    if change == "header is a list":
        notes = {**notes, b"covey": b"[]"}
    if change == "without time":
        table = table.drop_columns("time")
    pq.write_table(table.replace_schema_metadata(notes), saved)
    assert refused(saved) == "the record is damaged or cut off; simulate anew"


def test_a_file_cut_off_anywhere_is_refused(saved):
    content = saved.read_bytes()
    for length in {4, 5, len(content) // 2, len(content) - 8, len(content) - 1}:
        saved.write_bytes(content[:length])
        assert "damaged" in refused(saved)


def test_no_flipped_bit_ever_changes_a_game_unnoticed(game, saved):
    content, draw = saved.read_bytes(), random.Random(0)
    for _ in range(300):
        damaged = bytearray(content)
        damaged[draw.randrange(4, len(content))] ^= 1 << draw.randrange(8)
        saved.write_bytes(damaged)
        with suppress(covey.InputError):
            assert identical(covey.load_game(saved), game)  # a bit that says nothing


def test_a_record_of_an_earlier_version_assures_nothing(game, saved):
    table = pq.read_table(saved).drop_columns(["assurance"])
    notes = {b"covey": table.schema.metadata[b"covey"]}
    notes[b"covey_crc32"] = _checksum(notes[b"covey"], table)
    pq.write_table(table.replace_schema_metadata(notes), saved)
    assert identical(covey.load_game(saved), game)
    assert covey.load_game(saved).assurance == math.inf
