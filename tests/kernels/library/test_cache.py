"""A file of compiled kernels is named by all that decides what is in it, and whole."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from covey.kernels.library import cache

OBJECTS = [b"one" * 100, b"two" * 100]


@pytest.fixture
def kernels(tmp_path, monkeypatch):
    """A copy of the kernels' sources, of which the digest is taken."""
    copy = tmp_path / "kernels"
    shutil.copytree(cache.KERNELS, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(cache, "KERNELS", copy)
    cache.source_digest.cache_clear()
    yield copy
    cache.source_digest.cache_clear()


@pytest.mark.parametrize("source", ["arrays.py", "capture/path.py", "play/deeper/new.py"])
def test_a_change_of_any_source_gives_another_digest(kernels, source):
    before = cache.source_digest()
    (kernels / source).parent.mkdir(exist_ok=True)
    with (kernels / source).open("a") as file:
        file.write("# changed\n")
    cache.source_digest.cache_clear()
    assert cache.source_digest() != before


def test_a_copy_of_the_sources_has_the_same_digest(kernels):
    copied = cache.source_digest()
    cache.source_digest.cache_clear()
    for source in kernels.rglob("*.py"):
        source.touch()
    assert cache.source_digest() == copied


def test_each_processor_and_each_compiler_has_a_file_of_its_own(monkeypatch):
    first = cache.object_file(("haswell", "+avx2"))
    assert cache.object_file(("haswell", "+avx2")) == first
    assert cache.object_file(("haswell", "-avx2")) != first
    monkeypatch.setattr(cache, "_version_file", lambda _package: Path(__file__))
    assert cache.object_file(("haswell", "+avx2")) != first


def test_the_cache_is_where_the_environment_says(tmp_path, monkeypatch):
    monkeypatch.setenv("COVEY_CACHE_DIR", str(tmp_path))
    assert cache.object_file(("any", "")).parent == tmp_path
    monkeypatch.delenv("COVEY_CACHE_DIR")
    assert cache.cache_folder().name == "covey"


def test_objects_come_back_as_they_were_written(tmp_path):
    file = tmp_path / "kernels-1.bin"
    cache.write_objects(file, OBJECTS)
    assert cache.read_objects(file) == OBJECTS
    assert list(tmp_path.iterdir()) == [file]


def test_a_damaged_file_is_none(tmp_path):
    file = tmp_path / "kernels-1.bin"
    assert cache.read_objects(file) is None
    cache.write_objects(file, OBJECTS)
    whole = file.read_bytes()
    for length in range(0, len(whole), 7):
        file.write_bytes(whole[:length])
        assert cache.read_objects(file) is None, length
    for position in range(0, len(whole), 7):
        file.write_bytes(whole[:position] + bytes([whole[position] ^ 0xFF]) + whole[position + 1 :])
        assert cache.read_objects(file) is None, position


def test_a_file_is_written_whole_or_not_at_all(tmp_path, monkeypatch):
    file = tmp_path / "kernels-1.bin"

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(cache.Path, "replace", full)
    with pytest.raises(OSError, match="No space"):
        cache.write_objects(file, OBJECTS)
    assert list(tmp_path.iterdir()) == []


def test_what_a_killed_process_left_is_removed(tmp_path):
    (tmp_path / "kernels-0.4711.part").write_bytes(b"half")
    cache.write_objects(tmp_path / "kernels-1.bin", OBJECTS)
    assert [file.name for file in tmp_path.iterdir()] == ["kernels-1.bin"]


def test_files_that_were_used_longest_ago_are_forgotten(tmp_path):
    for k in range(12):
        cache.write_objects(tmp_path / f"kernels-{k:02}.bin", OBJECTS)
    assert len(list(tmp_path.iterdir())) == 8
    assert (tmp_path / "kernels-11.bin").exists()


def test_a_compiler_that_is_missing_is_named(monkeypatch):
    monkeypatch.setattr(cache.importlib.util, "find_spec", lambda _package: None)
    with pytest.raises(cache.BuildError, match="pip install numba llvmlite"):
        cache.object_file(("any", ""))
