"""What a run may end with, and what it must not."""

from __future__ import annotations

from collections.abc import Container
from pathlib import Path
from signal import SIGINT
from typing import NamedTuple

import covey

_PACKAGE = Path(covey.__file__).parent

_TOLD = ("covey: ", "  starts ", "saved ")
"""How the lines begin that covey prints on standard error."""

INTERRUPTED = 130
"""Exit status of covey after an interrupt."""

_TRACE = ("Traceback", "Fatal Python error", "Exception ignored")


class FaultError(AssertionError):
    """A fault had a consequence that it must not have."""


class SkippedError(Exception):
    """A fault can't be made on this machine; the message says why."""


class Ended(NamedTuple):
    """A process that has ended."""

    status: int
    output: str
    errors: str


def require(holds: bool, message: str) -> None:
    """Raise FaultError with the message unless a condition holds."""
    if not holds:
        raise FaultError(message)


def require_no_trace(ended: Ended) -> None:
    """Require that a process printed nothing that only a programmer can read."""
    require(not any(word in ended.errors for word in _TRACE), f"a traceback:\n{ended.errors}")


def require_told(ended: Ended, statuses: Container[int]) -> None:
    """Require one of the statuses, and nothing on standard error but covey's own lines."""
    require_no_trace(ended)
    lines = ended.errors.splitlines()
    strange = [line for line in lines if not line.startswith(_TOLD)]
    require(not strange, f"lines on standard error that are not covey's:\n{ended.errors}")
    require(ended.status in statuses, f"exit status {ended.status}:\n{ended.errors}")
    silent = ended.status in (0, -SIGINT)
    require(silent or bool(lines), f"exit status {ended.status} without a word")


def require_interrupted(ended: Ended) -> None:
    """Require one line about an interrupt.

    Before Python has begun to run covey's code, an interrupt is Python's own affair, with or
    without a traceback. When covey's code has ended, the signal itself ends the process. The same
    status comes from Python itself if the interrupt was raised in `exec` of a text, as dataclasses
    use it, though covey has caught it.
    """
    if str(_PACKAGE) in ended.errors or "Traceback" not in ended.errors:
        require_told(ended, [INTERRUPTED, -SIGINT])
