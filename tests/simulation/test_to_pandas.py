"""Games and studies as pandas data frames, where pandas is installed."""

from __future__ import annotations

import sys

import pytest

import covey

TEAM = covey.Team([(0.3, 0.1), (-0.2, 0.4)], [0.3, 2.0])


@pytest.fixture
def game():
    return covey.simulate(TEAM, covey.PursuerDisk(), update_time=0.2)


@pytest.fixture
def study(tmp_path):
    grid = {"team_size": 2, "update_time": 0.2, "sensing": "hidden"}
    return covey.run_study(covey.Study(starts=3, **grid), tmp_path / "results", workers=1)


def test_a_game_has_a_row_for_every_row_of_its_record(game):
    pytest.importorskip("pandas")
    frame = game.to_pandas()
    assert frame["time"].tolist() == game.times.tolist()
    assert frame["evader_1_y"].tolist() == game.evader_positions[:, 1, 1].tolist()
    assert frame["disk_radius"].tolist() == game.disk_radii.tolist()


def test_a_study_has_a_row_for_every_game(study):
    pytest.importorskip("pandas")
    frame = study.to_pandas()
    assert frame["survival_time"].tolist() == study.games["survival_time"].to_pylist()


def test_the_data_frame_of_a_game_is_the_file_that_pandas_reads(game, tmp_path):
    pandas = pytest.importorskip("pandas")
    covey.save_game(game, tmp_path / "game.parquet")
    pandas.testing.assert_frame_equal(
        game.to_pandas(), pandas.read_parquet(tmp_path / "game.parquet")
    )


@pytest.mark.parametrize("value", ["game", "study"])
def test_without_pandas_it_is_told_what_to_install(value, request, monkeypatch):
    value = request.getfixturevalue(value)
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(covey.InputError, match="to_pandas needs pandas: pip install pandas"):
        value.to_pandas()
