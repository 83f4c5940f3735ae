"""What a terminal shows while a command computes."""

from __future__ import annotations

from rich.console import Console
from rich.status import Status

from covey.kernels.library.load import load_library


def waiting(what: str) -> Status:
    """Load the kernels; then show in a terminal, until the block ends, what is being computed.

    Where there is no terminal, nothing is shown. A team of eight plans in less than a second, a
    team of twenty in minutes.
    """
    load_library()  # shows a bar of its own while it compiles
    return Console(stderr=True).status(f"{what} …")
