"""By which code, and on what machine, games are played."""

from __future__ import annotations

import hashlib
import os
import platform
from functools import cache
from importlib.metadata import version
from pathlib import Path

_LIBRARIES = ("numba", "llvmlite", "numpy", "pyarrow")
_PACKAGE = Path(__file__).parents[2]
_ROOMS = ("kernels", "model", "planning", "bounds", "simulation", "players", "scenarios", "studies")


@cache
def code_digest() -> str:
    """Return a digest of all of covey that a game depends on.

    A version number alone would not do: between two releases the code changes, and a study must
    not be finished by other code than began it.
    """
    return digest_of(_PACKAGE)


def digest_of(package: Path) -> str:
    """Return a digest of the sources, in rooms and their sub-rooms, that a game depends on."""
    digest = hashlib.sha256()
    for room in _ROOMS:
        for source in sorted((package / room).rglob("*.py")):
            digest.update(source.relative_to(package).as_posix().encode())
            digest.update(source.read_bytes())
    return digest.hexdigest()


def versions() -> dict[str, str]:
    """Return the versions of all that may change a digit of a result, or a byte of a file."""
    found = {"python": platform.python_version(), "covey": version("covey")}
    found |= {name: version(name) for name in _LIBRARIES}
    return {**found, "covey_code": code_digest()}


def machine() -> dict[str, object]:
    """Return what kind of machine this is, and nothing about whose."""
    return {
        "system": platform.system(),
        "architecture": platform.machine(),
        "processor": _processor(),
        "cores": os.cpu_count(),
    }


def _processor() -> str:
    """Name of the processor, where the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, platform.processor())
