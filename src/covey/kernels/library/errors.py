"""What may go wrong before a kernel runs."""

from __future__ import annotations


class BuildError(RuntimeError):
    """The kernels can't be compiled; the message says why."""
