"""Files to be written: checked before the work begins, so that no work is lost."""

from __future__ import annotations

import csv
import io
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import covey
from covey import views

_RESULTS = Path("results")
"""Folder of all results for which no other is asked for."""


def check_output(path: Path, endings: Sequence[str], what: str) -> None:
    """Raise InputError unless `path` ends in one of `endings`, OSError if it can't be written."""
    if path.suffix.lower() not in endings:
        wanted = " or ".join([", ".join(endings[:-1]), endings[-1]] if endings[1:] else endings)
        raise covey.InputError(f"{path}: expected a name that ends in {wanted} for {what}")
    if path.is_dir():
        raise covey.InputError(f"{path}: expected the name of a file, got a folder")
    from covey.simulation.files import check_writable  # only now, as it loads NumPy

    check_writable(path)


def results_folder(asked_for: Path | None, name: str) -> Path:
    """Return the folder for results: what was asked for, or else `name` in results/, and make it.

    Raises InputError if it can't be made, or takes no files.
    """
    from covey.simulation.files import make_folder  # only now, as it loads NumPy

    if asked_for is None:
        make_folder(_RESULTS)
    folder = _RESULTS / name if asked_for is None else asked_for
    make_folder(folder)
    return folder


def write_csv(path: Path, heads: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Write a table, and say where it is."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(rows)
    write_text(path, text.getvalue())


def write_text(path: Path, text: str) -> None:
    """Write a text, and say where it is."""
    from covey.simulation.files import whole_file  # only now, as it loads NumPy

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
