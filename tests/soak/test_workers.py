"""A worker that is lost is a failure of the seed that it played."""

from __future__ import annotations

import multiprocessing
from types import SimpleNamespace

import pytest

from soak import workers


class Worker:
    """A process that has ended, or that never reports."""

    def __init__(self, exitcode):
        self.exitcode, self.killed = exitcode, False

    def join(self):
        pass

    def kill(self):
        self.killed = True


@pytest.mark.parametrize(
    ("exitcode", "reason"), [(-11, "the worker died, exit -11"), (None, "no end after 0.05 s")]
)
def test_a_worker_that_is_lost_is_a_failure_of_the_seed_it_played(monkeypatch, exitcode, reason):
    ours, theirs = multiprocessing.Pipe(duplex=False)
    if exitcode is not None:
        theirs.close()
    worker = Worker(exitcode)
    started = (ours, worker, SimpleNamespace(value=77))
    monkeypatch.setattr(workers, "_start", lambda number, share: started)
    monkeypatch.setattr(workers, "REPORT_EVERY", 0.01)
    monkeypatch.setattr(workers, "PATIENCE", 0.05)
    told = workers.reports(70, None, 1)
    assert next(told).failure == (77, f"seed 77: {reason}")
    told.close()
    assert worker.killed == (exitcode is None)
