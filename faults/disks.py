"""Disks that are full, and folders that can only be read."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random

from faults.outcome import SkippedError, require, require_told
from faults.processes import COVEY, run
from faults.study import (
    command,
    describe_in,
    files,
    play,
    put_files,
    require_goes_on,
    require_whole_files,
    undisturbed,
)

_PAGE = 4096
_ENOUGH = "size=64m"
REFUSED = 2
"""Exit status of covey where it can't write."""

_LIMITED = """\
import resource, sys
from covey.__main__ import run
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv.pop(1)), resource.RLIM_INFINITY))
sys.exit(run())
"""


@contextmanager
def disk(folder: Path, options: str) -> Iterator[Path]:
    """Mount a small disk below a folder, which takes root."""
    path = folder / "disk"
    path.mkdir()
    try:
        mount("-t", "tmpfs", "-o", options, "tmpfs", str(path))
    except (OSError, subprocess.CalledProcessError) as error:
        raise SkippedError("no small disk can be mounted here, which takes root") from error
    try:
        yield path
    finally:
        subprocess.run(["umount", "--lazy", str(path)], check=True)


def mount(*words: str) -> None:
    """Run `mount`."""
    subprocess.run(["mount", *words], check=True, capture_output=True)


def full_disk(random: Random, folder: Path) -> None:
    """A study fills its disk; when there is room, it goes on."""
    needed = sum(map(len, undisturbed().files.values())) // _PAGE
    with disk(folder, f"size={_PAGE * random.randint(2, needed)}") as small:
        require_told(play(small), [0, REFUSED])
        require_whole_files(small)
        mount("-o", f"remount,{_ENOUGH}", str(small))
        require_goes_on(small)


def long_file(random: Random, folder: Path) -> None:
    """The system limits the length of a file; without the limit the study goes on."""
    longest = max(map(len, undisturbed().files.values()))
    limit = str(random.randint(0, longest))
    describe_in(folder)
    words = command("--workers", "1")
    require_told(run(folder, "-c", _LIMITED, limit, *words), [0, REFUSED])
    require_whole_files(folder)
    require_goes_on(folder)


def full_disk_for_a_game(random: Random, folder: Path) -> None:
    """The record of a game and its picture fill the disk; when there is room, they are made."""
    with disk(folder, f"size={_PAGE * random.randint(1, 40)}") as small:
        whole = _save_game(folder)
        done = _save_game(small)
        require(done.items() <= whole.items(), "a file that is not whole")
        mount("-o", f"remount,{_ENOUGH}", str(small))
        require(_save_game(small) == whole, "another game or picture")


def _save_game(folder: Path) -> dict[str, bytes]:
    """Save a game and its picture, as far as they can be; return the files."""
    for words in (
        ("simulate", "fig3", "-o", "game.parquet"),
        ("draw", "game.parquet", "-o", "game.png"),
    ):
        require_told(run(folder, *COVEY, *words), [0, REFUSED])
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def read_only(random: Random, folder: Path) -> None:
    """The folder of a study that is partly played can only be read; later it can be written to."""
    with disk(folder, _ENOUGH) as small:
        whole = undisturbed().files
        put_files(small, dict(random.sample(sorted(whole.items()), random.randint(0, len(whole)))))
        before = files(small)
        mount("-o", "remount,ro", str(small))
        require_told(run(small, *COVEY, *command("--workers", "1")), [REFUSED])
        mount("-o", "remount,rw", str(small))
        require(files(small) == before, "a file of a folder that can only be read has changed")
        require_goes_on(small)
