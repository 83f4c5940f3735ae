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
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from covey.model import LastCapture
from covey.simulation.files import make_folder, whole_file
from covey.studies.design.study import Study
from covey.studies.running.chunks import Chunk
from covey.studies.running.parts import DamagedPartError, Extent, read_part
from covey.studies.running.tables import GAMES, TRAJECTORIES, encoded
from covey.studies.running.worker import ChunkResult

LOG = "log.jsonl"


def prepare(folder: Path, *, trajectories: bool) -> None:
    """Make a results folder, and check before any work that files can be written to it."""
    for path in (folder, *(folder / kind for kind in kinds(trajectories))):
        make_folder(path)


def remove_leftovers(folder: Path) -> None:
    """Remove unfinished files of a run that was killed."""
    for leftover in [*folder.glob(".*.part"), *folder.glob("*/.*.part")]:
        with suppress(OSError):
            leftover.unlink()


def save_chunk(folder: Path, chunk: Chunk, result: ChunkResult) -> None:
    """Write the files of a chunk, the table of games last."""
    if result.trajectories is not None:
        _write(_part(folder, TRAJECTORIES, chunk.number), result.trajectories)
    _write(_part(folder, GAMES, chunk.number), result.games)


def is_saved(folder: Path, chunk: Chunk, study: Study) -> bool:
    """Return whether all files of a chunk exist and are undamaged."""
    cases = len(study.cases)
    one_objective = all(isinstance(each, LastCapture) for each in study.objective)
    first, last = chunk.first * cases, chunk.last * cases
    extent = Extent(first, last, cases, max(study.team_size), one_objective)
    return all(
        _is_whole(_part(folder, kind, chunk.number), kind, extent)
        for kind in kinds(study.trajectories)
    )


def _is_whole(path: Path, kind: str, extent: Extent) -> bool:
    """Return whether a file is the part of its games.

    Equal tables are encoded to equal bytes. So a file is damaged if its table, encoded again,
    differs from it. Parquet's own checksums do not cover the whole file.
    """
    try:
        content = path.read_bytes()
        return encoded(read_part(content, kind, extent)) == content
    except (OSError, DamagedPartError):  # missing or damaged
        return False


def append_to_log(folder: Path, entry: Mapping[str, Any]) -> None:
    """Append a line to the log."""
    with (folder / LOG).open("a", encoding="utf-8") as file:
        file.write(json.dumps(entry) + "\n")


def part_files(folder: Path, kind: str, count: int) -> dict[int, Path]:
    """Return the files that are there of `count` chunks, by the numbers of the chunks."""
    paths = {number: _part(folder, kind, number) for number in range(count)}
    return {number: path for number, path in paths.items() if path.exists()}


def kinds(trajectories: bool) -> tuple[str, ...]:
    """Return the tables of a study, each a folder of parts."""
    return (GAMES, TRAJECTORIES) if trajectories else (GAMES,)


def _part(folder: Path, kind: str, number: int) -> Path:
    return folder / kind / f"part-{number:05d}.parquet"


def _write(path: Path, content: bytes) -> None:
    with whole_file(path) as file:
        file.write(content)
