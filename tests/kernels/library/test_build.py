"""Compiled kernels come from the cache, and are built once where the cache has none."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from covey.kernels.library import build
from covey.kernels.library.cache import host_processor, object_file, read_objects
from covey.kernels.library.errors import BuildError

OBJECTS = [b"first", b"second"]


@pytest.fixture
def builds(tmp_path, monkeypatch):
    """The folders that a builder in place of the compiler was asked for; the cache is empty."""
    monkeypatch.setenv("COVEY_CACHE_DIR", str(tmp_path / "cache"))
    asked = []

    def quick(folder):
        asked.append(folder)
        time.sleep(0.3)
        return OBJECTS

    monkeypatch.setattr(build, "_build", quick)
    return asked


def test_kernels_are_built_once(builds):
    assert build.built_objects() == build.built_objects() == [b"first", b"second"]
    assert builds == [object_file(host_processor()).parent]


def test_two_that_begin_at_once_build_once(builds, capsys):
    with ThreadPoolExecutor(4) as executor:
        found = list(executor.map(lambda _: build.built_objects(), range(4)))
    assert found == [[b"first", b"second"]] * 4
    assert len(builds) == 1
    assert "another process is compiling the kernels" in capsys.readouterr().err


def test_where_kernels_cannot_be_kept_processes_that_are_started_find_them(
    builds, tmp_path, capsys
):
    (tmp_path / "cache").write_text("a file, where the folder should be", encoding="utf-8")
    assert build.built_objects() == OBJECTS
    shared = object_file(host_processor())
    assert shared.parent != tmp_path / "cache"
    assert read_objects(shared) == OBJECTS
    assert (len(builds), capsys.readouterr().err.count("can't be kept")) == (1, 1)


BUILDER = """
import sys, time
from pathlib import Path
from covey.kernels.library.cache import write_objects

with open("built", "a") as file:
    print("once", file=file)
time.sleep(1.0)
write_objects(Path(sys.argv[1]), [b"first", b"second"])
"""

BUILDING = f"""
import sys
from covey.kernels.library import build

build._BUILDER = [sys.executable, "-c", {BUILDER!r}]
print("ready", flush=True)
sys.stdin.readline()
print(build.built_objects())
"""


def test_two_processes_that_begin_at_once_build_once(tmp_path):
    """Both find an empty cache; the second waits for the first."""
    both = [
        subprocess.Popen(
            [sys.executable, "-c", BUILDING],
            cwd=tmp_path,
            env={**os.environ, "COVEY_CACHE_DIR": str(tmp_path / "cache")},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
        )
        for _ in range(2)
    ]
    assert [process.stdout.readline() for process in both] == ["ready\n"] * 2
    for process in both:
        process.stdin.write("go\n")
        process.stdin.flush()
    ended = [process.communicate(timeout=60) for process in both]
    assert [output for output, _ in ended] == [f"{OBJECTS}\n"] * 2
    assert (tmp_path / "built").read_text().split() == ["once"]
    told = sorted(errors for _, errors in ended)
    assert told[0] == "covey: another process is compiling the kernels; waiting for it\n"
    assert told[1].startswith("covey: compiling its kernels into ")
    assert sorted(path.suffix for path in (tmp_path / "cache").iterdir()) == [".bin", ".lock"]


@pytest.mark.parametrize("damaged", [b"", b"PK", b"no archive at all"])
def test_a_damaged_file_is_built_again(builds, damaged):
    build.built_objects()
    object_file(host_processor()).write_bytes(damaged)
    assert build.built_objects() == [b"first", b"second"]
    assert len(builds) == 2


def test_a_folder_that_cannot_be_written_is_said_and_the_kernels_are_used(
    builds, tmp_path, monkeypatch, capsys
):
    (tmp_path / "file").touch()
    monkeypatch.setenv("COVEY_CACHE_DIR", str(tmp_path / "file" / "below"))
    assert build.built_objects() == [b"first", b"second"]
    said = capsys.readouterr().err
    assert said.count(str(tmp_path / "file" / "below")) == 1
    assert "COVEY_CACHE_DIR" in said
    assert len(builds) == 1


def test_a_full_disk_is_said_and_the_kernels_are_used(builds, monkeypatch, capsys):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(build, "write_objects", full)
    assert build.built_objects() == OBJECTS
    assert "No space left on device" in capsys.readouterr().err
    assert len(builds) == 1


def test_a_builder_that_fails_is_reported(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("COVEY_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(build, "_BUILDER", [sys.executable, "-c", "raise SystemExit('no memory')"])
    with pytest.raises(BuildError, match=r"could not be compiled:\s*no memory"):
        build.built_objects()
    assert str(tmp_path) in capsys.readouterr().err
