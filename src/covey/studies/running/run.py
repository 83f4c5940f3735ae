"""`run_study`: play the games of a study that are missing in a folder, and save them there."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from covey.studies.design.study import Study
from covey.studies.design.study_file import read_study
from covey.studies.running import result_files
from covey.studies.running.chunks import Chunk, chunks_of
from covey.studies.running.executors import open_executor
from covey.studies.running.lock import locked
from covey.studies.running.manifest import (
    manifest_of,
    read_manifest,
    refuse_differences,
    write_manifest,
)
from covey.studies.running.results import StudyResult, load_study
from covey.studies.running.scheduler import Failure, Scheduler
from covey.studies.running.worker import ChunkResult

Progress = Callable[[int, int], None]
"""Called with the numbers of games done and of all games, first before any game of this run."""


def run_study(
    study: Study | str | os.PathLike[str],
    folder: str | os.PathLike[str],
    *,
    workers: int | None = None,
    dask: str | None = None,
    progress: Progress | None = None,
) -> StudyResult:
    """Play all games of a study that an earlier run has not saved in the folder.

    Parameters
    ----------
    study
        A `Study`, or its TOML file.
    folder
        Where the results go. A run may be killed at any moment and started again. The tables are
        the same, byte for byte, for any interruption and any number of workers.
    workers
        Processes on this machine, at least 1; by default the number of cores. With 1 the games are
        played in this process.
    dask
        Address of the scheduler of a Dask cluster, tcp://... The same version of covey must be
        installed on its workers. The folder is written to from this process only.
    progress
        Called with the numbers of games done and of all games, at the start and after every chunk.

    Returns
    -------
    StudyResult
        The same as from `load_study`, and in `failures` the games that could not be played.

    Raises
    ------
    InputError
        If the study or an argument is invalid, if the folder holds another study, or if another run
        is writing to it.
    OSError
        If a file can't be written, on a full disk for example. Files of earlier chunks stay intact.

    Examples
    --------
    >>> import tempfile
    >>> import covey
    >>> study = covey.Study(starts=2, team_size=2, update_time=0.1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     games = covey.run_study(study, folder, workers=1).games
    ...
    >>> games.num_rows  # two starts, each hidden and visible
    4
    """
    chosen = study if isinstance(study, Study) else read_study(study)
    path = Path(folder)
    result_files.prepare(path, trajectories=chosen.trajectories)
    with locked(path):
        _write_or_check_manifest(path, chosen)
        result_files.remove_leftovers(path)
        failures = _play_missing(chosen, path, workers, dask, progress)
    return StudyResult(path, load_study(path).manifest, tuple(map(str, failures)))


def _write_or_check_manifest(folder: Path, study: Study) -> None:
    """Write the manifest, or make sure that the one in the folder is this study's."""
    before, now = read_manifest(folder), manifest_of(study)
    if before is None:
        write_manifest(folder, now)
    else:
        refuse_differences(folder, before, now)


def _play_missing(
    study: Study,
    folder: Path,
    workers: int | None,
    dask: str | None,
    progress: Progress | None,
) -> list[Failure]:
    """Play the chunks that have no file yet, and write the log of this run."""
    cases, chunks = len(study.cases), chunks_of(study)
    missing = [chunk for chunk in chunks if not result_files.is_saved(folder, chunk, study)]
    done = study.games - cases * sum(chunk.last - chunk.first for chunk in missing)
    report = progress or (lambda _done, _all: None)
    report(done, study.games)
    if not missing:
        return []

    def save(chunk: Chunk, result: ChunkResult) -> None:
        nonlocal done
        result_files.save_chunk(folder, chunk, result)
        result_files.append_to_log(folder, _cost(chunk, result))
        done += cases * (chunk.last - chunk.first)
        report(done, study.games)

    began = time.perf_counter()
    with open_executor(workers, dask) as executor:
        begin = {"event": "run", "workers": executor.size, "parts": len(missing)}
        result_files.append_to_log(folder, begin)
        failures = executor.supervise(
            lambda stop: Scheduler(study, executor, save, stop).run(missing)
        )
    for failure in failures:
        entry = {"event": "failure", **failure._asdict(), "chunk": failure.chunk.number}
        result_files.append_to_log(folder, entry)
    end = {"event": "end", "seconds": round(time.perf_counter() - began, 3)}
    result_files.append_to_log(folder, end)
    return failures


def _cost(chunk: Chunk, result: ChunkResult) -> dict[str, Any]:
    return {
        "event": "part",
        "part": chunk.number,
        "seconds": round(result.seconds, 4),
        "cpu_seconds": round(result.cpu_seconds, 4),
        "playing_seconds": round(result.playing_seconds, 4),
    }
