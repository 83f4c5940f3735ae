"""The code and the machine that games are played with."""

from __future__ import annotations

import hashlib
import os
import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

_LIBRARIES = ("numba", "llvmlite", "numpy", "pyarrow")
_PACKAGE = Path(__file__).parents[2]
_CODE = (
    "kernels",
    "model",
    "planning",
    "bounds",
    "simulation",
    "players",
    "scenarios",
    "studies",
)


@cache
def code_digest() -> str:
    """Return a digest of all sources of covey that a game depends on.

    A study must be finished by the code that began it. The version number does not tell, as code
    changes between two releases.
    """
    return digest_of(_PACKAGE)


def digest_of(package: Path) -> str:
    """Return a digest of the sources of a package in all folders that a game depends on."""
    digest = hashlib.sha256()
    for folder in _CODE:
        for source in sorted((package / folder).rglob("*.py")):
            digest.update(source.relative_to(package).as_posix().encode())
            digest.update(source.read_bytes())
    return digest.hexdigest()


def versions() -> dict[str, str]:
    """Return the versions of everything that may change a number or a byte of the tables."""
    found = {"python": platform.python_version(), "covey": version("covey")}
    found |= {name: _version(name) for name in _LIBRARIES}
    return {**found, "covey_code": code_digest()}


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:  # the compiler, where covey came with its kernels compiled
        return "not installed"


def machine() -> dict[str, object]:
    """Return the kind of this machine, without anything that identifies its owner."""
    return {
        "system": platform.system(),
        "architecture": platform.machine(),
        "processor": _processor(),
        "cores": os.cpu_count(),
    }


def _processor() -> str:
    """Name of the processor; may be empty."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, platform.processor())
