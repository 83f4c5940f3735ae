"""Where compiled kernels are kept: one file, named by all that decides what is in it.

A change of a kernel's source, of the compiler's version or of the processor gives another name. So
no stale file can answer.
"""

from __future__ import annotations

import hashlib
import importlib.util
import marshal
import os
import sys
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

import platformdirs

from covey.kernels.library.errors import BuildError

KERNELS = Path(__file__).parent.parent

_COMPILER = ("numba", "llvmlite")
_CHECKSUM = hashlib.sha256().digest_size
_MOST_FILES = 8
"""Files that are kept, the last used: of other versions, or of other processors."""


def cache_folder() -> Path:
    """Return the folder for compiled kernels: `COVEY_CACHE_DIR`, or the user's cache folder."""
    chosen = os.environ.get("COVEY_CACHE_DIR")
    return Path(chosen) if chosen else platformdirs.user_cache_path("covey", appauthor=False)


@cache
def source_digest() -> str:
    """Return a digest of the sources of all kernels."""
    digest = hashlib.sha256()
    for source in sorted(KERNELS.rglob("*.py")):
        digest.update(f"{source.relative_to(KERNELS).as_posix()}\0".encode())
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def host_processor() -> tuple[str, str]:
    """Return the name of this machine's processor, and its features, as LLVM knows them."""
    import llvmlite.binding as llvm

    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def object_file(processor: Iterable[str]) -> Path:
    """Return the file of the kernels for a processor, which is a name and its features."""
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    made_of = hashlib.sha256("\n".join([python, *processor]).encode())
    for name in _COMPILER:
        made_of.update(_version_file(name).read_bytes())
    return cache_folder() / f"kernels-{source_digest()}-{made_of.hexdigest()[:16]}.bin"


def _version_file(package: str) -> Path:
    """Return the file that tells the version of a package; the package isn't imported."""
    found = importlib.util.find_spec(package)
    if found is None or found.origin is None:
        raise BuildError(
            f"covey's kernels are still to be compiled, and {package} isn't installed: "
            f"pip install {' '.join(_COMPILER)}"
        )
    return Path(found.origin).with_name("_version.py")


def read_objects(file: Path) -> list[bytes] | None:
    """Return the objects in a file; None if there is none, or if a bit of the file is damaged."""
    try:
        content = file.read_bytes()
    except OSError:
        return None
    checksum, listed = content[:_CHECKSUM], content[_CHECKSUM:]
    if hashlib.sha256(listed).digest() != checksum:
        return None
    objects: list[bytes] = marshal.loads(listed)
    return objects


def write_objects(file: Path, objects: Sequence[bytes]) -> None:
    """Write objects to a file, whole or not at all; forget the files that were used longest ago.

    The file is a checksum and the list of the objects. One process at a time may write.
    """
    listed = marshal.dumps(list(objects))
    part = file.with_suffix(f".{os.getpid()}.part")
    try:
        part.write_bytes(hashlib.sha256(listed).digest() + listed)
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)
    for abandoned in file.parent.glob("kernels-*.part"):  # by a process that was killed
        abandoned.unlink(missing_ok=True)
    by_age = sorted(file.parent.glob("kernels-*.bin"), key=_last_used)
    for old in by_age[:-_MOST_FILES]:
        old.unlink(missing_ok=True)


def _last_used(file: Path) -> float:
    status = file.stat()
    return max(status.st_atime, status.st_mtime)
