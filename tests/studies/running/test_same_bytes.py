"""The tables of a study are the same, byte for byte, whoever plays it, stopped or not."""

from __future__ import annotations

import subprocess
import sys
import time

import pytest

from covey.model import InputError
from covey.studies import load_study, run_study
from covey.studies.running.lock import locked
from studies.small_studies import files, small_study


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """The files of a run by one worker from beginning to end."""
    folder = tmp_path_factory.mktemp("undisturbed")
    run_study(small_study(), folder, workers=1)
    return files(folder)


def test_three_workers_write_what_one_does(tmp_path, undisturbed):
    run_study(small_study(), tmp_path, workers=3)
    assert files(tmp_path) == undisturbed


def test_a_run_that_was_killed_goes_on(tmp_path, undisturbed):
    folder = tmp_path / "results"
    with subprocess.Popen([sys.executable, "-c", KILLED, str(folder)]) as process:
        wait_for(folder / "games" / "part-00001.parquet")
        process.kill()
    there = files(folder)
    assert there.items() < undisturbed.items()
    (folder / "games" / ".part-00009.parquet.0.part").write_bytes(b"half")
    ages = {path: path.stat().st_mtime_ns for path in folder.glob("games/part-*")}

    calls = []
    run_study(small_study(), folder, workers=1, progress=lambda *done: calls.append(done))

    assert files(folder) == undisturbed
    assert not list(folder.glob("*/.*"))
    assert all(path.stat().st_mtime_ns == age for path, age in ages.items())
    assert calls[0] == (sum(64 for _ in ages), 200)
    assert calls[-1] == (200, 200)


# Slowed down, so that there is time to kill it.
KILLED = """
import sys, time
from covey.studies import Study, run_study
study = Study(starts=50, team_size=[2, 3], update_time=0.1, seed=3)
run_study(study, sys.argv[1], workers=1, progress=lambda done, total: time.sleep(0.3))
"""


def wait_for(path):
    late = time.monotonic() + 120.0
    while not path.exists():
        assert time.monotonic() < late
        time.sleep(0.01)


@pytest.mark.parametrize("damage", ["cut", "bit", "gone"])
def test_a_damaged_part_is_played_again(tmp_path, undisturbed, damage):
    run_study(small_study(), tmp_path, workers=1)
    part = tmp_path / "games" / "part-00002.parquet"
    content = bytearray(part.read_bytes())
    if damage == "gone":
        part.unlink()
    elif damage == "cut":
        part.write_bytes(content[:-10])
    else:
        content[200] ^= 16
        part.write_bytes(content)
    assert files(tmp_path) != undisturbed
    run_study(small_study(), tmp_path, workers=1)
    assert files(tmp_path) == undisturbed


def test_another_study_is_refused_with_the_difference(tmp_path):
    run_study(small_study(starts=2), tmp_path, workers=1)
    before = files(tmp_path)
    with pytest.raises(InputError) as caught:
        run_study(small_study(starts=2, seed=4, speed=[0.2, 0.3]), tmp_path, workers=1)
    message = str(caught.value)
    assert "holds another study" in message
    assert "seed: is 3 there, and 4 now" in message
    assert "grid.speed: is [0.25] there, and [0.2, 0.3] now" in message
    assert "turn_rate" not in message
    assert files(tmp_path) == before


def test_games_of_other_code_are_not_mixed_in(tmp_path, monkeypatch):
    run_study(small_study(starts=2), tmp_path, workers=1)
    monkeypatch.setattr("covey.studies.running.manifest.versions", lambda: {"covey_code": "other"})
    with pytest.raises(InputError, match=r'covey_code: is .* there, and "other" now'):
        run_study(small_study(starts=2), tmp_path, workers=1)


@pytest.mark.skipif(sys.platform == "win32", reason="no lock there")
def test_two_runs_in_one_folder_are_one_too_many(tmp_path):
    with locked(tmp_path), pytest.raises(InputError, match="another run of a study is at work"):
        run_study(small_study(starts=2), tmp_path, workers=1)


def test_results_are_read_back(tmp_path):
    pandas = pytest.importorskip("pandas")
    run_study(small_study(), tmp_path, workers=1)
    result = load_study(tmp_path)
    assert result.is_complete
    assert result.study == small_study().describe() | {"grid": result.study["grid"]}
    assert result.manifest["seed"] == 3
    assert "covey" in result.manifest["versions"]
    ours, theirs = result.to_pandas(), pandas.read_parquet(tmp_path / "games")
    pandas.testing.assert_frame_equal(ours, theirs)
    with pytest.raises(InputError, match=r"there is no manifest\.json"):
        load_study(tmp_path / "games")
