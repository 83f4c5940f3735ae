"""Compiled kernels that the cache has not: built once, in a process of its own.

The compiler's settings are global to a process. So the kernels are built in another process, and
the compiler of the user's own code isn't touched.
"""

from __future__ import annotations

import atexit
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from filelock import FileLock, Timeout

from covey.kernels.library.cache import (
    KERNELS,
    host_processor,
    object_file,
    read_objects,
    write_objects,
)
from covey.kernels.library.errors import BuildError
from covey.kernels.library.progress import progress, say

_BUILDER = [sys.executable, "-m", "covey.kernels.builder"]


def built_objects() -> list[bytes]:
    """Build the objects for this processor, keep them if the cache can be written, return them.

    Raises
    ------
    BuildError
        If the builder fails.
    """
    file, objects = object_file(host_processor()), None
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with _one_at_a_time(file.with_name("kernels.lock")):
            objects = read_objects(file)  # by another process, while this process waited
            if objects is None:
                objects = _build(file.parent)
                write_objects(file, objects)
    except OSError as error:
        say(
            f"{file.parent}: {error.strerror}. The compiled kernels can't be kept there, so the "
            f"next command compiles again; set COVEY_CACHE_DIR to a folder that can be written"
        )
        objects = objects or _build(file.parent)
        _share_with_children(file.name, objects)
    return objects


def _share_with_children(name: str, objects: list[bytes]) -> None:
    """Keep the objects for the processes that this process starts, as long as it lives."""
    with suppress(OSError):
        folder = tempfile.mkdtemp(prefix="covey-")
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        write_objects(Path(folder) / name, objects)
        os.environ["COVEY_CACHE_DIR"] = folder


@contextmanager
def _one_at_a_time(file: Path) -> Iterator[None]:
    """Let one process build, and another wait for it."""
    lock = FileLock(file)
    try:
        lock.acquire(blocking=False)
    except Timeout:
        say("another process is compiling the kernels; waiting for it")
        lock.acquire()
    try:
        yield
    finally:
        lock.release()


def _build(folder: Path) -> list[bytes]:
    """Run the builder, which prints its progress, a share in [0, 1] a line."""
    printed = []
    with tempfile.TemporaryDirectory() as temporary, progress(folder) as advance:
        file = Path(temporary) / "kernels.bin"
        with subprocess.Popen(
            [*_BUILDER, str(file)],
            env=_environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
        ) as process:
            try:
                for line in process.stdout or ():
                    printed.append(line)
                    advance(line)
            finally:
                process.kill()
        objects = read_objects(file)
    if objects is None:
        raise BuildError(f"the kernels could not be compiled:\n{''.join(printed[-30:])}")
    return objects


def _environment() -> dict[str, str]:
    """Return this environment, with this package where the builder finds it."""
    package, path = str(KERNELS.parent.parent), os.environ.get("PYTHONPATH")
    return {**os.environ, "PYTHONPATH": os.pathsep.join([package, path] if path else [package])}
