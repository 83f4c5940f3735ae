"""What a terminal shows while a command computes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import Progress
from rich.status import Status

from covey.kernels.library.load import load_library


def waiting(what: str) -> Status:
    """Load the kernels; then show in a terminal, until the block ends, what is being computed.

    Where there is no terminal, nothing is shown. A team of eight plans in less than a second, a
    team of twenty in half a minute, a team of fifty in minutes.
    """
    load_library()  # shows a bar of its own while it compiles
    return Console(stderr=True).status(f"{what} …")


@contextmanager
def counting(what: str, total: int) -> Iterator[Callable[[], None]]:
    """Load the kernels; then show a bar in a terminal, which goes on with each call."""
    load_library()
    console = Console(stderr=True)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task(what, total=total)
        yield lambda: bar.advance(task)
