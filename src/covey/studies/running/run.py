"""Run a study: the one function that this room is for."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from covey.studies.design.study import Study
from covey.studies.design.study_file import read_study
from covey.studies.running import folder as store
from covey.studies.running.chunks import Chunk, chunks_of
from covey.studies.running.executors import hired
from covey.studies.running.lock import locked
from covey.studies.running.manifest import (
    manifest_of,
    read_manifest,
    refuse_differences,
    write_manifest,
)
from covey.studies.running.results import StudyResult, load_study
from covey.studies.running.scheduler import Conductor
from covey.studies.running.worker import Parts

Progress = Callable[[int, int], None]
"""Called with the number of games done and of all games; first with those done in earlier runs."""


def run_study(
    study: Study | str | os.PathLike[str],
    folder: str | os.PathLike[str],
    *,
    workers: int | None = None,
    dask: str | None = None,
    progress: Progress | None = None,
) -> StudyResult:
    """Play all games of a study, or those that a run which was stopped has left.

    Parameters
    ----------
    study
        A `Study`, or its TOML file.
    folder
        Where the results go. Everything is there at any moment, so the run may be killed and
        started again; the tables come out the same, byte for byte, as they do for any number of
        workers.
    workers
        Processes on this machine; by default as many as it has cores. With 1 the games are played
        in this process.
    dask
        Address of the scheduler of a Dask cluster, tcp://... The folder needs to be seen from here
        only; covey must be installed on the workers in this very version.
    progress
        Called with the numbers of games done and of all, at the start and after every chunk.

    Returns
    -------
    StudyResult
        What `load_study` reads back; `failures` tells which games could not be played.

    Raises
    ------
    InputError
        If the study or an argument can't be used, if the folder holds another study, or if another
        run is at work there.
    OSError
        If a file can't be written, on a full disk for example. What is there stays intact.
    """
    chosen = study if isinstance(study, Study) else read_study(study)
    place = Path(folder)
    store.prepare(place, trajectories=chosen.trajectories)
    with locked(place):
        _claim(place, chosen)
        store.remove_leftovers(place)
        failures = _play_missing(chosen, place, workers, dask, progress)
    return StudyResult(place, load_study(place).manifest, tuple(map(str, failures)))


def _claim(folder: Path, study: Study) -> None:
    """Write the manifest or, if there is one, make sure that it is this study's."""
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
) -> list[Any]:
    cases, chunks = len(study.cases), chunks_of(study)
    missing = [chunk for chunk in chunks if not store.is_kept(folder, chunk, cases)]
    done = study.games - cases * sum(chunk.last - chunk.first for chunk in missing)
    report = progress or (lambda _done, _all: None)
    report(done, study.games)
    if not missing:
        return []

    def keep(chunk: Chunk, parts: Parts) -> None:
        nonlocal done
        store.keep(folder, chunk, parts)
        store.note(folder, _cost(chunk, parts))
        done += cases * (chunk.last - chunk.first)
        report(done, study.games)

    began = time.perf_counter()
    with hired(workers, dask) as crew:
        store.note(folder, {"event": "run", "workers": crew.size, "parts": len(missing)})
        failures = Conductor(study, crew, keep).conduct(missing)
    for failure in failures:
        store.note(folder, {"event": "failure", **failure._asdict(), "chunk": failure.chunk.number})
    store.note(folder, {"event": "end", "seconds": round(time.perf_counter() - began, 3)})
    return failures


def _cost(chunk: Chunk, parts: Parts) -> dict[str, Any]:
    return {
        "event": "part",
        "part": chunk.number,
        "seconds": round(parts.seconds, 4),
        "cpu_seconds": round(parts.cpu_seconds, 4),
        "playing_seconds": round(parts.playing_seconds, 4),
    }
