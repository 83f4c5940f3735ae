"""What a terminal shows while a command computes."""

from __future__ import annotations

from rich.console import Console
from rich.status import Status


def waiting(what: str) -> Status:
    """Show in a terminal, until the block ends, what is being computed; print nothing elsewhere.

    A team of up to eight plans faster than one can read it; a team of twenty takes minutes.
    """
    return Console(stderr=True).status(f"{what} …")
