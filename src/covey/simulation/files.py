"""Files that appear whole or not at all; whether one can be written is known before the work.

A file and a folder for results are made where they are asked for, the folder around them is not:
a mistyped path is an error, and not a new tree of folders.
"""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from covey.model import InputError


@contextmanager
def whole_file(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """Open a file for writing that appears under its name when it is complete, or never."""
    target = Path(path)
    with _part_of(target) as part:
        with part.open("xb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())  # or a power cut could leave the name without the content
        part.replace(target)


def check_writable(path: str | os.PathLike[str]) -> None:
    """Raise the error that `whole_file` would raise, and leave nothing there."""
    target = Path(path)
    with _part_of(target) as part:
        part.open("xb").close()


def make_folder(folder: Path) -> None:
    """Make a folder for results, unless it is there; raise InputError if it takes no files."""
    try:
        folder.mkdir(exist_ok=True)
        check_writable(folder / "results")
    except FileExistsError:
        raise InputError(f"{folder}: expected a folder, got a file") from None
    except OSError as error:
        reason = _reason(error, folder).removeprefix("can't be written: ")
        raise InputError(f"{folder}: can't be written to: {reason}") from error


@contextmanager
def _part_of(target: Path) -> Iterator[Path]:
    """Return where the part of a file may be written until the file is complete.

    The part is removed at the end if it is still there. Errors name the file, not the part.
    """
    part = target.with_name(f".{target.name}.{secrets.token_hex(4)}.part")
    try:
        yield part
    except OSError as error:
        reason = f"can't be written: {_reason(error, target)}"
        raise OSError(error.errno, reason, str(target)) from error
    finally:
        with suppress(OSError):  # the part became the file, or was never made
            part.unlink()


def _reason(error: OSError, path: Path) -> str:
    if isinstance(error, FileNotFoundError) and not path.parent.exists():
        return f"there is no folder {path.parent}; make it first: mkdir -p {path.parent}"
    return error.strerror or str(error)
