"""Views by their names, from what there is (a scenario or a record) to a file."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console
from rich.progress import Progress

from covey import views
from covey.cli.shared.outputs import check_output, print_saved
from covey.model import InputError
from covey.scenarios import Scenario
from covey.simulation import Game, save_game
from covey.views.film.mp4 import require_video
from covey.views.kit.saving import FILMS, STILLS

_OF_GAMES = {"snapshots": views.draw_snapshots, "game": views.draw_game}


def draw_view(source: Scenario | Game, view: str | None, output: Path, record: Path | None) -> None:
    """Draw a view of a plan or a game; a scenario is played, and the record saved, first.

    Whatever can't go well is found before the game is played.
    """
    chosen = _checked_view(view, output)
    if chosen == "plan":
        _draw_plan(source, output, record)
        return
    if record is not None:
        check_output(record, [".parquet"], "the record of a game")
    game = source.simulate() if isinstance(source, Scenario) else source
    if record is not None:
        save_game(game, record)
        print_saved(record)
    if chosen == "animation":
        save_film(game, output)
    else:
        print_saved(views.save(_OF_GAMES[chosen](game), output))


def save_film(game: Game, path: Path) -> None:
    """Save a film, with a bar that shows how far it is, and say where."""
    console = Console(stderr=True)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task(f"drawing {path.name}", total=None)
        views.animate(
            game,
            path,
            progress=lambda done, total: progress.update(task, completed=done, total=total),
        )
    print_saved(path)


def _checked_view(view: str | None, output: Path) -> str:
    """Choose the view, and raise InputError if it can't be saved as asked."""
    suffix = output.suffix.lower()
    if view is None:
        check_output(output, [*STILLS, *FILMS], "a picture or a film")
    elif view == "animation":
        check_output(output, FILMS, "the view animation")
    else:
        check_output(output, STILLS, f"the view {view}")
    if suffix == ".mp4":
        require_video()
    return view or ("animation" if suffix in FILMS else "snapshots")


def _draw_plan(source: Scenario | Game, output: Path, record: Path | None) -> None:
    if record is not None:
        raise InputError("--record: the view plan plays no game; choose another --view")
    if not isinstance(source, Scenario):
        raise InputError(
            "the view plan needs a scenario, got the record of a game; the view snapshots shows "
            "with which plan it began"
        )
    figure = views.draw_plan(source.team, source.disk, source.plan())
    print_saved(views.save(figure, output))
