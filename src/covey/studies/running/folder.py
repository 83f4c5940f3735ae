"""A results folder: the manifest, one file for each chunk, a log.

    manifest.json                      written first, never changed
    games/part-00000.parquet           the table of games, chunk by chunk
    trajectories/part-00000.parquet    the courses of the games, on request
    log.jsonl                          what each chunk cost, and which failed

A part is there whole or not at all, so a run can be killed at any moment. What may differ from run
to run, as the clock does, is in the log alone.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from covey.model import InputError
from covey.simulation.storage import whole_file
from covey.studies.running.chunks import Chunk
from covey.studies.running.tables import GAMES, MOMENTS, decoded, encoded
from covey.studies.running.worker import Parts

LOG = "log.jsonl"


def part_path(folder: Path, kind: str, number: int) -> Path:
    """Return the file of a chunk."""
    return folder / kind / f"part-{number:05d}.parquet"


def prepare(folder: Path, *, trajectories: bool) -> None:
    """Make a results folder, or find out that it can't be written to, before any work."""
    kinds = [GAMES, MOMENTS] if trajectories else [GAMES]
    try:
        for kind in kinds:
            (folder / kind).mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError) as error:
        raise InputError(f"{folder}: expected a folder, but {error.filename} is a file") from error
    except OSError as error:
        raise InputError(f"{folder}: can't be written to: {error.strerror}") from error
    for place in (folder, *(folder / kind for kind in kinds)):
        if not os.access(place, os.W_OK | os.X_OK):
            raise InputError(f"{place}: can't be written to: permission denied")


def remove_leftovers(folder: Path) -> None:
    """Remove what a run left half written when it was killed."""
    for leftover in [*folder.glob(".*.part"), *folder.glob("*/.*.part")]:
        with suppress(OSError):
            leftover.unlink()


def keep(folder: Path, chunk: Chunk, parts: Parts) -> None:
    """Write the files of a chunk; the table of games comes last, as it says that all is there."""
    if parts.trajectories is not None:
        _write(part_path(folder, MOMENTS, chunk.number), parts.trajectories)
    _write(part_path(folder, GAMES, chunk.number), parts.games)


def is_kept(folder: Path, chunk: Chunk, cases: int) -> bool:
    """Return whether the games of a chunk are there and sound.

    The same table gives the same bytes, so a part that isn't what its own table would be written
    as has been damaged. Parquet's checksums don't cover everything.
    """
    import pyarrow as pa

    try:
        content = part_path(folder, GAMES, chunk.number).read_bytes()
        table = decoded(content)
        numbers = table["game"]
        if encoded(table) != content:
            return False
    except (OSError, KeyError, pa.ArrowException):  # not there, or damaged: played again
        return False
    wanted = (chunk.last - chunk.first) * cases
    return len(numbers) == wanted and numbers[0].as_py() == chunk.first * cases


def note(folder: Path, entry: Mapping[str, Any]) -> None:
    """Append a line to the log."""
    with (folder / LOG).open("a", encoding="utf-8") as file:
        file.write(json.dumps(entry) + "\n")


def part_files(folder: Path, kind: str = GAMES) -> Iterator[Path]:
    """Return the parts that are there, in the order of their games."""
    yield from sorted((folder / kind).glob("part-*.parquet"))


def _write(path: Path, content: bytes) -> None:
    with whole_file(path) as file:
        file.write(content)
