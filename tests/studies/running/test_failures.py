"""What fails or dies is reported with its seed, and the rest of the study goes on."""

from __future__ import annotations

import errno
import json
import os
import signal

import numpy as np
import pytest

from covey.model import InputError
from covey.studies import run_study
from covey.studies.running import result_files
from studies.small_studies import files, small_study

BAD = 20
"""The start that can't be played; it is in the second of four parts."""

KILL = getattr(signal, "SIGKILL", signal.SIGTERM)
"""What no process outlives; on Windows that is SIGTERM."""


def study_with(mishap, **changes):
    """A study whose team has a mishap in one start."""
    place = small_study(team_size=3).start(BAD, 3).positions[0, 0]

    def team(situation):
        if situation.time == 0.0 and situation.team.positions[0, 0] == place:
            mishap()
        return np.zeros(len(situation.evaders))

    given = {"evaders": team, "team_size": 3, "turn_rate": [1.0, 2.0], **changes}
    return small_study(**given)


@pytest.mark.parametrize("workers", [1, 2])
def test_a_chunk_that_fails_is_left_out_and_reported(tmp_path, workers):
    def mishap():
        raise ZeroDivisionError("no heading")

    study = study_with(mishap)
    result = run_study(study, tmp_path, workers=workers)
    assert len(result.failures) == 1, result.failures
    failure = result.failures[0]
    seed = study.start(BAD, 3).seed
    assert failure == (
        f"starts 16 to 31 are missing: start {BAD} (seed {seed}): ZeroDivisionError: no heading"
    )
    assert not result.is_complete
    assert result.games["start"].to_numpy()[::4].tolist() == [*range(16), *range(32, 50)]
    assert result.moments.starts == 50 - 16
    log = [json.loads(line) for line in (tmp_path / result_files.LOG).read_text().splitlines()]
    assert [entry["seed"] for entry in log if entry["event"] == "failure"] == [seed]


def test_a_dead_worker_is_replaced_and_its_chunk_tried_again(tmp_path):
    grave = tmp_path / "grave"

    def mishap():
        if not grave.exists():
            grave.touch()
            os.kill(os.getpid(), KILL)

    result = run_study(study_with(mishap), tmp_path / "died", workers=2)
    assert not result.failures
    assert result.is_complete
    run_study(study_with(lambda: None), tmp_path / "lived", workers=1)
    assert files(tmp_path / "died") == files(tmp_path / "lived")


def test_the_start_that_kills_every_worker_is_found(tmp_path):
    def mishap():
        os.kill(os.getpid(), KILL)

    study = study_with(mishap)
    result = run_study(study, tmp_path, workers=2)
    assert len(result.failures) == 1, result.failures
    failure = result.failures[0]
    assert f"start {BAD} (seed {study.start(BAD, 3).seed})" in failure
    assert "\n" not in failure
    assert result.games.num_rows == 4 * (50 - 16)


def test_a_full_disk_is_an_error_and_leaves_what_is_there(tmp_path, monkeypatch):
    study = small_study()
    run_study(study, tmp_path / "whole", workers=1)
    write = result_files._write

    def full(path, content):
        if path.name == "part-00002.parquet":
            raise OSError(errno.ENOSPC, "can't be written: No space left on device", str(path))
        write(path, content)

    monkeypatch.setattr(result_files, "_write", full)
    with pytest.raises(OSError, match="No space left on device"):
        run_study(study, tmp_path / "full", workers=1)
    monkeypatch.undo()
    there = files(tmp_path / "full")
    assert len(there) == 3
    assert there.items() < files(tmp_path / "whole").items()
    run_study(study, tmp_path / "full", workers=1)
    assert files(tmp_path / "full") == files(tmp_path / "whole")


def test_a_folder_that_cannot_be_written_to_is_an_error(tmp_path):
    (tmp_path / "file").write_text("mine")
    with pytest.raises(InputError, match="file: expected a folder, got a file"):
        run_study(small_study(), tmp_path / "file", workers=1)
    with pytest.raises(InputError, match="results: can't be written to: Not a directory"):
        run_study(small_study(), tmp_path / "file" / "results", workers=1)
    with pytest.raises(InputError, match=r"there is no folder .*none; make it first: mkdir -p "):
        run_study(small_study(), tmp_path / "none" / "results", workers=1)
    assert (tmp_path / "file").read_text() == "mine"
    assert list(tmp_path.iterdir()) == [tmp_path / "file"]


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="chmod doesn't lock folders on Windows")
@pytest.mark.skipif("os.geteuid() == 0", reason="the superuser may write everywhere")
def test_a_locked_folder_is_an_error(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(InputError, match="can't be written to: "):
        run_study(small_study(), tmp_path / "results", workers=1)


def test_workers_and_a_cluster_exclude_each_other(tmp_path):
    with pytest.raises(InputError, match="workers: expected nothing beside dask"):
        run_study(small_study(), tmp_path, workers=2, dask="tcp://127.0.0.1:1")
    with pytest.raises(InputError, match="workers: expected a whole number >= 1, got 0"):
        run_study(small_study(), tmp_path, workers=0)
