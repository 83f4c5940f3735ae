"""A film of a game, with a bar that shows how far the drawing is."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console
from rich.progress import Progress

from covey import views
from covey.cli.shared.outputs import print_saved


def save_film(film: views.Film, path: Path) -> None:
    """Save a film, and say where."""
    console = Console(stderr=True)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task(f"drawing {path.name}", total=None)
        film.save(
            path,
            progress=lambda done, total: progress.update(task, completed=done, total=total),
        )
    print_saved(path)
