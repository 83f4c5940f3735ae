"""The cache of compiled kernels: cut, empty for two processes at once, not to be written.

Each of these compiles the kernels, which takes the minute that it takes.
"""

from __future__ import annotations

import shutil
from contextlib import ExitStack
from functools import cache
from pathlib import Path
from random import Random

from covey.kernels.library.cache import cache_folder, host_processor, object_file, read_objects
from covey.kernels.library.load import load_library
from faults.disks import disk, mount
from faults.outcome import Ended, require, require_told
from faults.processes import COVEY, SOURCES, ended, run, running

PLAN = (*COVEY, "plan", "fig3", "--json")
_CUTS = 500


@cache
def _expected() -> str:
    """Return what is printed when the kernels are in the cache."""
    load_library()
    done = run(Path.cwd(), *PLAN)
    require(done.status == 0 and not done.errors, done.errors)
    return done.output


def _require_the_plan(done: Ended) -> None:
    require_told(done, [0])
    require(done.output == _expected(), f"another plan is printed: {done.output}")


def _kernels_in(folder: Path) -> Path:
    """Return the file of the kernels where `folder` is the cache."""
    return folder / object_file(host_processor()).name


def cut_kernels(random: Random, folder: Path) -> None:
    """The file of the kernels is cut. It is compiled again, and is whole afterwards."""
    _expected()
    file = _kernels_in(folder)
    content = (cache_folder() / file.name).read_bytes()
    for length in [0, *(random.randrange(len(content)) for _ in range(_CUTS))]:
        file.write_bytes(content[:length])
        require(read_objects(file) is None, f"read though cut after {length} bytes")
    _require_the_plan(run(folder, *PLAN, COVEY_CACHE_DIR=str(folder)))
    require(read_objects(file) is not None, "the cache has no whole file")


def two_builds(_random: Random, folder: Path) -> None:
    """Two processes find an empty cache. One compiles, the other waits, and both go on."""
    with ExitStack() as stack:
        both = [
            stack.enter_context(running(folder, *PLAN, COVEY_CACHE_DIR=str(folder)))
            for _ in range(2)
        ]
        done = [ended(each) for each in both]
    for each in done:
        _require_the_plan(each)
    compiled = [each for each in done if "compiling its kernels into" in each.errors]
    require(len(compiled) == 1, f"{len(compiled)} processes have compiled")
    require(read_objects(_kernels_in(folder)) is not None, "the cache has no whole file")


def full_cache(random: Random, folder: Path) -> None:
    """The cache is on a full disk. The kernels are used from memory, and it is said once."""
    with disk(folder, f"size={4096 * random.randint(1, 50)}") as small:
        _require_used_from_memory(run(folder, *PLAN, COVEY_CACHE_DIR=str(small)))


def read_only_home(_random: Random, folder: Path) -> None:
    """Neither covey's own files nor the user's home can be written to."""
    with disk(folder, "size=64m") as home:
        shutil.copytree(SOURCES / "covey", home / "covey")
        mount("-o", "remount,ro", str(home))
        variables = {"HOME": str(home), "XDG_CACHE_HOME": "", "COVEY_CACHE_DIR": ""}
        program = f"import sys; sys.path.insert(0, {str(home)!r}); "
        program += "from covey.__main__ import run; sys.exit(run())"
        _require_used_from_memory(run(folder, "-c", program, *PLAN[2:], **variables))


def _require_used_from_memory(done: Ended) -> None:
    _require_the_plan(done)
    said = done.errors.count("can't be kept there")
    require(said == 1, f"it is said {said} times that kernels can't be kept")
