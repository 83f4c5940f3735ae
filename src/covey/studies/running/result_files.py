"""The files of a study's results.

    manifest.json                      written first, never changed
    games/part-00000.parquet           the table of games, a file for each chunk
    trajectories/part-00000.parquet    the trajectories of the games, on request
    log.jsonl                          what each chunk cost, and which failed

A file appears complete or not at all, so a run can be killed at any moment. Values that differ from
run to run, such as times of the clock, are written to the log only.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from covey.model import InputError
from covey.simulation.storage import whole_file
from covey.studies.running.chunks import Chunk
from covey.studies.running.tables import GAMES, TRAJECTORIES, decoded, encoded
from covey.studies.running.worker import ChunkResult

LOG = "log.jsonl"


def prepare(folder: Path, *, trajectories: bool) -> None:
    """Make a results folder, and check before any work that files can be written to it."""
    parts = [folder / kind for kind in ([GAMES, TRAJECTORIES] if trajectories else [GAMES])]
    try:
        for path in parts:
            path.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError) as error:
        raise InputError(f"{folder}: expected a folder, but {error.filename} is a file") from error
    except OSError as error:
        raise InputError(f"{folder}: can't be written to: {error.strerror}") from error
    for path in (folder, *parts):
        if not os.access(path, os.W_OK | os.X_OK):
            raise InputError(f"{path}: can't be written to: permission denied")


def remove_leftovers(folder: Path) -> None:
    """Remove unfinished files of a run that was killed."""
    for leftover in [*folder.glob(".*.part"), *folder.glob("*/.*.part")]:
        with suppress(OSError):
            leftover.unlink()


def save_chunk(folder: Path, chunk: Chunk, result: ChunkResult) -> None:
    """Write the files of a chunk. The table of games comes last: it marks the chunk as complete."""
    if result.trajectories is not None:
        _write(_part(folder, TRAJECTORIES, chunk), result.trajectories)
    _write(_part(folder, GAMES, chunk), result.games)


def is_saved(folder: Path, chunk: Chunk, cases: int) -> bool:
    """Return whether the table of a chunk's games exists and is undamaged.

    Equal tables are encoded to equal bytes. So a file is damaged if its table, encoded again,
    differs from it. Parquet's own checksums do not cover the whole file.
    """
    import pyarrow as pa

    try:
        content = _part(folder, GAMES, chunk).read_bytes()
        table = decoded(content)
        numbers = table["game"]
        if encoded(table) != content:
            return False
    except (OSError, KeyError, pa.ArrowException):  # missing or damaged
        return False
    count = (chunk.last - chunk.first) * cases
    return len(numbers) == count and numbers[0].as_py() == chunk.first * cases


def append_to_log(folder: Path, entry: Mapping[str, Any]) -> None:
    """Append a line to the log."""
    with (folder / LOG).open("a", encoding="utf-8") as file:
        file.write(json.dumps(entry) + "\n")


def part_files(folder: Path, kind: str = GAMES) -> list[Path]:
    """Return the files of all saved chunks, in the order of their games."""
    return sorted((folder / kind).glob("part-*.parquet"))


def _part(folder: Path, kind: str, chunk: Chunk) -> Path:
    return folder / kind / f"part-{chunk.number:05d}.parquet"


def _write(path: Path, content: bytes) -> None:
    with whole_file(path) as file:
        file.write(content)
