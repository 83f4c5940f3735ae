"""What a terminal shows while a command computes."""

from __future__ import annotations

from rich.console import Console
from rich.status import Status


def waiting(what: str) -> Status:
    """Show that something is going on until the block ends; elsewhere than in a terminal, nothing.

    Up to a team of eight there is hardly time to read it; one of twenty plans for a minute or two.
    """
    return Console(stderr=True).status(f"{what} …")
