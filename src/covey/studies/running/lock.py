"""A lock that lets only one run at a time write to a folder."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from covey.model import InputError


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Lock a folder. The system releases the lock if this process dies."""
    try:
        import fcntl
    except ImportError:  # Windows has no fcntl, so two runs at a time are not noticed there
        yield
        return
    with (folder / ".lock").open("w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError(f"{folder}: another run of a study is at work here") from error
        yield
