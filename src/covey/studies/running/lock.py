"""One run at a time in one folder."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from covey.model import InputError


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Keep others out of a folder; the system lets go of the lock when this process dies."""
    try:
        import fcntl
    except ImportError:  # Windows: no lock, and no harm as long as nobody runs a study twice
        yield
        return
    with (folder / ".lock").open("w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError(f"{folder}: another run of a study is at work here") from error
        yield
