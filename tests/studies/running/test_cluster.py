"""A real Dask cluster plays the same study as one process."""

from __future__ import annotations

import pytest

from covey.model import InputError
from covey.studies import run_study
from studies.small_studies import files, small_study

distributed = pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def address():
    """Two processes behind a scheduler."""
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster:
        yield cluster.scheduler_address


def test_a_cluster_writes_what_one_process_does(tmp_path, address):
    result = run_study(small_study(), tmp_path / "cluster", dask=address)
    assert result.is_complete
    run_study(small_study(), tmp_path / "alone", workers=1)
    assert files(tmp_path / "cluster") == files(tmp_path / "alone")


def test_a_chunk_that_fails_on_a_cluster_is_reported(tmp_path, address):
    def team(situation):
        raise ZeroDivisionError("no heading")

    study = small_study(evaders=team, starts=2)
    (failure,) = run_study(study, tmp_path, dask=address).failures
    assert f"start 0 (seed {study.start(0, 2).seed}): ZeroDivisionError" in failure


def test_no_cluster_is_an_error(tmp_path, monkeypatch):
    monkeypatch.setattr("covey.studies.running.executors._CLUSTER_SECONDS", 1)
    with pytest.raises(InputError, match="no cluster with workers answers at tcp://127"):
        run_study(small_study(), tmp_path, dask="tcp://127.0.0.1:9")
