"""What is said while the kernels are compiled: a bar in a terminal, else a line."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path


def say(message: str) -> None:
    """Print a message where it doesn't mix with results."""
    print(f"covey: {message}", file=sys.stderr, flush=True)


@contextmanager
def progress(folder: Path) -> Iterator[Callable[[str], None]]:
    """Say that kernels are compiled into a folder; yield a function that takes the share done."""
    say(f"compiling its kernels into {folder}: half a minute to a minute, once")
    if not sys.stderr.isatty():
        yield lambda _share: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn()
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("compiling", total=1.0)
        yield lambda share: bar.update(task, completed=_number(share))


def _number(share: str) -> float | None:
    try:
        return float(share)
    except ValueError:  # a warning of the builder
        return None
