"""Parquet files are read by the calling thread alone."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from covey.simulation.parquet import read_table

TABLE = pa.table({"x": np.arange(3.0), "name": ["a", "b", "c"]})

COUNTS_THREADS = """\
import os, sys
import numpy, pyarrow.parquet
from covey.simulation.parquet import read_table

def threads():
    return set(os.listdir("/proc/self/task"))

before = threads()
read_table(open(sys.argv[1], "rb").read())
print(len(threads() - before))
"""


@pytest.fixture
def saved(tmp_path):
    path = tmp_path / "table.parquet"
    pq.write_table(TABLE, path)
    return path


def test_a_file_and_its_content_give_the_same_table(saved):
    assert read_table(saved).equals(TABLE)
    assert read_table(saved.read_bytes()).equals(TABLE)


def test_columns_that_share_a_name_are_refused(tmp_path):
    pq.write_table(pa.table([[1.0], [2.0]], names=["x", "x"]), tmp_path / "twice.parquet")
    with pytest.raises(ValueError, match="a name of its own"):
        read_table(tmp_path / "twice.parquet")


# A thread that still holds the content when Python ends makes Python abort.
@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="counts threads as Linux does")
def test_reading_starts_no_thread(saved):
    command = [sys.executable, "-c", COUNTS_THREADS, str(saved)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert int(done.stdout) == 0
