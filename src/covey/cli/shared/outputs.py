"""Files to be written: looked at before the work begins, so that none is done in vain."""

from __future__ import annotations

import csv
import errno
import io
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path


def check_output(path: Path, endings: Sequence[str], what: str) -> None:
    """Raise InputError unless `path` ends as `what` must, OSError if it can't be written."""
    from covey.model import InputError

    if path.suffix.lower() not in endings:
        wanted = " or ".join([", ".join(endings[:-1]), endings[-1]] if endings[1:] else endings)
        raise InputError(f"{path}: expected a name that ends in {wanted} for {what}")
    if path.is_dir():
        raise InputError(f"{path}: expected the name of a file, got a folder")
    check_folder(path.parent)


def check_folder(folder: Path) -> None:
    """Make `folder`, and raise OSError unless it takes new files."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = f"the folder can't be made: {error.strerror}"
        raise OSError(error.errno, reason, str(folder)) from error
    if not os.access(folder, os.W_OK | os.X_OK):
        raise PermissionError(errno.EACCES, "can't write to this folder", str(folder))


def write_csv(path: Path, heads: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Write a table, and say where it is."""
    from covey.simulation.storage import whole_file

    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(rows)
    with whole_file(path) as file:
        file.write(text.getvalue().encode())
    print_saved(path)


def print_saved(path: Path) -> None:
    """Say where a file is; on standard error, where it isn't in the way of JSON."""
    print(f"saved {path}", file=sys.stderr)
