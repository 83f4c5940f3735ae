"""The one place that decides how kernels are compiled."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import numba
from numba.core import event

Function = TypeVar("Function", bound=Callable[..., object])


# - nogil: kernels touch no Python object, so threads may run them in parallel.
# - error_model="numpy": a division by zero gives inf as in NumPy, and no test for it stands in the
#   inner loops.
# - no fastmath: the guarantee is compared with what happens to 1e-9, and the same game must give
#   the same bits on every path through the code.
_COMMON = {"nogil": True, "error_model": "numpy"}

# Without numba's runtime nothing can be allocated, and no array is counted: the counting took four
# fifths of the time of an interception.
_NO_ALLOCATION = {"_nrt": False}


def compiled(function: Function) -> Function:
    """Compile a kernel that allocates nothing, and keep the machine code on disk.

    Compiling all kernels takes the better part of a minute, reading them back a fraction of a
    second.
    """
    decorated: Function = numba.njit(cache=True, **_COMMON, **_NO_ALLOCATION)(function)
    return decorated


def inlined(function: Function) -> Function:
    """Compile a small kernel into each of its callers.

    It isn't kept on disk: what comes from there is machine code, which LLVM can call but no longer
    inline, and a call costs as much as an interception.
    """
    decorated: Function = numba.njit(forceinline=True, **_COMMON, **_NO_ALLOCATION)(function)
    return decorated


def expanded(function: Function) -> Function:
    """Expand a kernel's code into each of its callers before they are compiled.

    Without numba's runtime a compiled function can't return an array. An expanded one returns none.
    """
    decorated: Function = numba.njit(inline="always", **_COMMON, **_NO_ALLOCATION)(function)
    return decorated


class _Announcer(event.Listener):  # type: ignore[misc] # numba's types are skipped
    """Says, once, that kernels are being compiled; numba calls it only when none is on disk."""

    def __init__(self) -> None:
        self._said = False

    def on_start(self, event: event.Event) -> None:
        function = event.data["dispatcher"].py_func
        if not self._said and function.__module__.startswith("covey.kernels"):
            self._said = True
            print(
                "covey: compiling its kernels, which takes up to a minute and happens only once",
                file=sys.stderr,
                flush=True,
            )

    def on_end(self, event: event.Event) -> None:
        """Nothing to say: the answer that was waited for follows."""


def forget_stale_cache(room: Path) -> None:
    """Remove compiled kernels that are older than any source of this room or of its sub-rooms.

    numba looks only at the file in which a kernel stands, so a change in one that it *calls*
    would go unnoticed.
    """
    newest = max(source.stat().st_mtime for source in room.rglob("*.py"))
    for index in room.rglob("__pycache__/*.nbi"):
        try:
            if index.stat().st_mtime < newest:
                index.unlink()
        except OSError:  # another process was quicker, or the folder is read-only
            continue


forget_stale_cache(Path(__file__).parent)
event.register("numba:compile", _Announcer())
