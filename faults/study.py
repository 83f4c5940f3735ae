"""The study that is disturbed, and what its result must be.

The undisturbed result is that of one process from beginning to end: the table on the screen, the
manifest, and every file of games and of trajectories. The log has durations and so it differs.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Mapping
from contextlib import AbstractContextManager
from functools import cache
from pathlib import Path
from random import Random
from signal import Signals
from typing import NamedTuple

from faults.outcome import Ended, require, require_told
from faults.processes import COVEY, Run, ended, running

RESULTS = "results"
_FILE = "study.toml"
_OPERATIONS = 50
"""A few more than an undisturbed run has on the files of its results."""

_STUDY = """\
starts = 48
seed = 3
trajectories = true

[grid]
team_size = [2, 3]
update_time = 0.05
sensing = ["visible", "hidden"]
"""


class Undisturbed(NamedTuple):
    """An undisturbed run: what it printed, its files, how long it took."""

    output: str
    files: dict[str, bytes]
    seconds: float


def describe_in(folder: Path) -> None:
    """Write the study's file into a folder."""
    (folder / _FILE).write_text(_STUDY, encoding="utf-8")


def command(*how: str) -> tuple[str, ...]:
    """Return the words after `covey` that run the study, and how it is to be played."""
    return ("study", _FILE, "--output", RESULTS, *how)


def begin(folder: Path, workers: int = 1) -> AbstractContextManager[Run]:
    """Start the study in a folder."""
    describe_in(folder)
    return running(folder, *COVEY, *command("--workers", str(workers)))


def begin_and_strike_at_file(
    random: Random, folder: Path, signal: Signals
) -> AbstractContextManager[Run]:
    """Start the study in a folder; it gets a signal at any of its operations on files."""
    describe_in(folder)
    where = str(random.randint(1, _OPERATIONS))
    words = command("--workers", "1")
    return running(folder, "-m", "faults.at_file", where, str(signal.value), *words)


def play(folder: Path, workers: int = 1) -> Ended:
    """Run the study in a folder, to its end."""
    with begin(folder, workers) as process:
        return ended(process)


@cache
def undisturbed(workers: int = 1) -> Undisturbed:
    """Return what the study comes to, and how long so many workers take."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        began = time.monotonic()
        done = play(folder, workers)
        seconds = time.monotonic() - began
        require_told(done, [0])
        return Undisturbed(done.output, files(folder), seconds)


def files(folder: Path) -> dict[str, bytes]:
    """Return the result's files that must not depend on how the study was played."""
    results = folder / RESULTS
    found = [path for path in results.rglob("*") if path.is_file()]
    return {
        path.relative_to(results).as_posix(): path.read_bytes()
        for path in sorted(found)
        if path.name not in ("log.jsonl", ".lock")
    }


def put_files(folder: Path, contents: Mapping[str, bytes]) -> None:
    """Write a result's files into a folder, as an earlier run may have left them."""
    describe_in(folder)
    for name, content in contents.items():
        path = folder / RESULTS / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def moment(random: Random, workers: int = 1) -> float:
    """Return a moment in the run of the study, in seconds after its start."""
    return random.uniform(0.0, undisturbed(workers).seconds)


def require_whole_files(folder: Path) -> None:
    """Require that every file that has its final name has its final content."""
    expected = undisturbed().files
    cut = [
        name
        for name, content in files(folder).items()
        if not name.endswith(".part") and content != expected.get(name)
    ]
    require(not cut, f"files that are not whole: {', '.join(cut)}")


def require_undisturbed(folder: Path, done: Ended) -> None:
    """Require that a run that ended left the undisturbed result."""
    require_told(done, [0])
    expected = undisturbed()
    require(done.output == expected.output, f"another table is printed:\n{done.output}")
    found = files(folder)
    differing = [name for name, content in expected.files.items() if found.get(name) != content]
    require(not differing, f"files that are missing or differ: {', '.join(differing)}")
    more = sorted(set(found) - set(expected.files))
    require(not more, f"files that should not be there: {', '.join(more)}")


def require_goes_on(folder: Path, workers: int = 1) -> None:
    """Require that the same command, run again, leaves the undisturbed result."""
    require_undisturbed(folder, play(folder, workers))
