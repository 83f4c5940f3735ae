"""Machine code that is older than a source is forgotten, in sub-rooms too."""

from __future__ import annotations

import os

import pytest

from covey.kernels._jit import forget_stale_cache


@pytest.mark.parametrize("cached", ["__pycache__", "capture/__pycache__"])
@pytest.mark.parametrize("source", ["path.py", "capture/path.py", "capture/arc/path.py"])
def test_machine_code_older_than_any_source_is_forgotten(tmp_path, cached, source):
    index, changed = tmp_path / cached / "kernel.nbi", tmp_path / source
    for file, age in ((index, 1_000), (changed, 2_000)):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
        os.utime(file, (age, age))
    forget_stale_cache(tmp_path)
    assert not index.exists()


def test_machine_code_younger_than_every_source_is_kept(tmp_path):
    index, source = tmp_path / "__pycache__" / "kernel.nbi", tmp_path / "path.py"
    index.parent.mkdir()
    for file, age in ((index, 2_000), (source, 1_000)):
        file.touch()
        os.utime(file, (age, age))
    forget_stale_cache(tmp_path)
    assert index.exists()
