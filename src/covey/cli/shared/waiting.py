"""What a terminal shows while a command computes."""

from __future__ import annotations

from rich.console import Console
from rich.status import Status

from covey.kernels.library.load import load_library


def waiting(what: str) -> Status:
    """Load the kernels; then show in a terminal, until the block ends, what is being computed.

    Elsewhere it prints nothing.
    A team of up to eight plans faster than one can read it; a team of twenty takes minutes.
    """
    load_library()  # shows a bar of its own while it compiles
    return Console(stderr=True).status(f"{what} …")
