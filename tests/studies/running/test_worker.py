"""What a worker of a study loads before it can play."""

from __future__ import annotations

import pickle
import subprocess
import sys

from covey.studies import AsVisible
from covey.studies.running.games import play_start
from covey.studies.running.worker import play_chunk
from studies.small_studies import small_study

UNUSED = [
    *("pydantic", "pyarrow", "matplotlib", "numba", "loky", "scipy", "dask", "distributed"),
    *("rich", "cyclopts", "covey.studies.analysis", "covey.studies.running.run"),
]

WORKER = f"""
import pickle, sys
_, play_start, study = pickle.load(sys.stdin.buffer)
games = list(play_start(study, 0))
print(len(games), [name for name in {UNUSED} if name in sys.modules])
"""


def test_a_worker_loads_nothing_that_it_does_not_play_with():
    study = small_study(pursuer=AsVisible())
    done = subprocess.run(
        [sys.executable, "-c", WORKER],
        input=pickle.dumps((play_chunk, play_start, study)),
        capture_output=True,
        check=False,
    )
    assert (done.stdout.split(maxsplit=1), done.stderr) == ([b"4", b"[]\n"], b"")
