"""Records that a page opens: shown if they are sound, else refused."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import covey
from covey.web.game import upload
from covey.web.game.game_json import MAX_FRAMES
from web.session_pages import Page


def test_a_record_goes_out_and_comes_in_unchanged(tmp_path):
    page = Page(evaders=3, seed=8, sensing="hidden")
    page.play()
    (content,) = page.ask(type="save", game="yours")
    (mine,) = page.ask(type="film", game="yours")
    (opened,) = page.send(content)
    assert opened == {**mine, "game": "opened"}
    path = tmp_path / "game.parquet"
    path.write_bytes(content)
    assert covey.load_game(path).survival_time == mine["survival_time"]


def test_a_record_of_simulate_is_shown(tmp_path):
    team = covey.Team([[300.0, 0.0], [0.0, -400.0]], [0.0, 1.0], 2.5, [math.inf, 0.001])
    game = covey.simulate(team, covey.PursuerDisk(speed=10.0), update_time=0.01)
    assert len(game.times) > MAX_FRAMES
    path = tmp_path / "game.parquet"
    covey.save_game(game, path)
    page = Page()
    (film,) = page.send(path.read_bytes())
    json.dumps(film, allow_nan=False)
    assert film["cast"]["turn_rates"] == [None, 0.001]
    assert len(film["pictures"]) <= MAX_FRAMES + 4
    times = [picture["time"] for picture in film["pictures"]]
    assert times == sorted(times)
    for i, when in zip(game.capture_sequence, game.capture_times, strict=True):
        after = next(p for p in film["pictures"] if [i, when] in p["captured"])
        assert after["time"] == when


def test_what_is_no_record_is_refused(tmp_path, monkeypatch):
    page = Page()
    assert "isn't Parquet" in page.error(b"no record")
    assert "damaged" in page.error(b"PAR1" + bytes(100))
    path = tmp_path / "game.parquet"
    team = covey.Team([[0.3, 0.0]], [0.0])
    covey.save_game(covey.simulate(team, covey.PursuerDisk()), path)
    content = path.read_bytes()
    assert "damaged" in page.error(content[: len(content) // 2])
    assert "damaged" in page.error(content.replace(b"time", b"\x80ime"))  # not UTF-8
    monkeypatch.setattr(upload, "MOST_NUMBERS", 10)
    assert "at most 10 numbers" in page.error(content)
    monkeypatch.setattr(upload, "MOST_BYTES", 10)
    assert "at most 10 bytes" in page.error(content)


@pytest.mark.parametrize(
    "column",
    [
        pa.array(["x" * 10**6] * 5),
        pa.array([b"x" * 10**6] * 5),
        pa.array([[1.0] * 10**6] * 5),
        pa.array([b"x" * 1000] * 5, pa.binary(1000)),
    ],
)
def test_a_small_file_with_a_huge_entry_is_refused_unread(column, tmp_path, monkeypatch):
    pq.write_table(pa.table({"time": column}), tmp_path / "bomb.parquet", compression="zstd")
    monkeypatch.setattr(upload, "read_game", None)
    assert "one number a row" in Page().error((tmp_path / "bomb.parquet").read_bytes())


@pytest.mark.parametrize(
    "forged",
    [
        {"guarantee": math.nan},
        {"guarantees": np.full(3, np.inf)},
        {"critical_sequences": np.full((3, 1), 7)},
        {"evader_positions": np.full((3, 1, 2), np.nan)},
        {"pursuer_positions": np.full((3, 2), np.nan)},
        {"strategies": {"evaders": {"name": "x"}, "pursuer": 3}},
        {"disk_radii": np.full(3, -1.0)},
    ],
)
def test_a_record_that_contradicts_itself_is_refused(tmp_path, forged):
    team = covey.Team([[0.015, 0.0]], [0.0])
    game = covey.simulate(team, covey.PursuerDisk())
    assert len(game.times) == 3
    path = tmp_path / "game.parquet"
    covey.save_game(replace(game, **forged), path)
    assert "record: it contradicts itself" in Page().error(path.read_bytes())
