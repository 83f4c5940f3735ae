"""Files to be written: checked before the work begins, so that no work is lost."""

from __future__ import annotations

import csv
import errno
import io
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import covey
from covey import views


def check_output(path: Path, endings: Sequence[str], what: str) -> None:
    """Raise InputError unless `path` ends in one of `endings`, OSError if it can't be written."""
    if path.suffix.lower() not in endings:
        wanted = " or ".join([", ".join(endings[:-1]), endings[-1]] if endings[1:] else endings)
        raise covey.InputError(f"{path}: expected a name that ends in {wanted} for {what}")
    if path.is_dir():
        raise covey.InputError(f"{path}: expected the name of a file, got a folder")
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
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(rows)
    write_text(path, text.getvalue())


def write_text(path: Path, text: str) -> None:
    """Write a text, and say where it is."""
    from covey.simulation.storage import whole_file  # only now, as it loads NumPy

    with whole_file(path) as file:
        file.write(text.encode())
    print_saved(path)


def save_picture(figure: Any, folder: Path, name: str) -> None:
    """Save a picture in every format, and say where the first file is."""
    from covey.views.kit.saving import STILLS  # only now, as it loads matplotlib

    for ending in STILLS:
        views.save(figure, folder / f"{name}{ending}")
    print_saved(folder / f"{name}{STILLS[0]}")


def print_saved(path: Path) -> None:
    """Say where a file is, on standard error: standard output may be JSON."""
    print(f"saved {path}", file=sys.stderr)
