"""`covey draw`: pictures and films of games and plans."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from cyclopts import Parameter

import covey
from covey import views
from covey.cli.shared.arguments import FileOrName, Seed
from covey.cli.shared.outputs import check_output, print_saved
from covey.cli.shared.sources import read_scenario_or_game
from covey.cli.show.film import save_film

View = Literal["snapshots", "game", "plan", "tree", "animation"]


def draw(
    file: Annotated[
        FileOrName,
        Parameter(
            name="FILE",
            help="Record of a game, or a scenario, which is played first: its file, or the name "
            "of one that comes with covey. Or the folder with the results of a study.",
        ),
    ],
    /,
    *,
    output: Annotated[
        Path,
        Parameter(
            name=["--output", "-o"],
            help="Where to. The ending says how: .png, .svg or .pdf for a picture; .gif for a "
            "film, or .mp4 with the extra `video` installed.",
        ),
    ],
    view: Annotated[
        View | None,
        Parameter(
            help="snapshots: moments of the game. game: all paths and captures. plan: the "
            "first plan, and the captures that it must expect. tree: the plan that answers "
            "captures, and what it will be after each first capture. animation: a film. By "
            "default a film if the output is one, else snapshots."
        ),
    ] = None,
    depth: Annotated[
        int | None,
        Parameter(help="With --view tree: how many captures are answered; by default all."),
    ] = None,
    record: Annotated[
        Path | None,
        Parameter(help="Save the record of the game that was played here, before it is drawn."),
    ] = None,
    title: Annotated[
        str | None, Parameter(help="Above the picture; by default what it shows, or none.")
    ] = None,
    size: Annotated[
        float | None,
        Parameter(help="Width in inches; by default one or two columns of a paper, 3.5 or 7."),
    ] = None,
    times: Annotated[
        list[float] | None,
        Parameter(
            consume_multiple=True,
            negative="",
            help="Moments of the view snapshots, as in --times 0 1.5 4; by default the start, a "
            "fifth and a half of the game, and its end.",
        ),
    ] = None,
    seed: Seed = None,
) -> None:
    """Draw a game, a plan or a study.

    Try:

        covey draw game.parquet --output game.png
        covey draw fig3 --view plan --output plan.pdf
        covey draw fig3 --record game.parquet --output game.gif
        covey draw fig3 --times 0 1 2 6 --title "Six units of time" --size 5 -o moments.pdf
        covey draw results/tournament --output tournament.png
    """
    look = _look(title, size)
    if Path(file).is_dir():
        if any(option is not None for option in (view, depth, record, times, seed)):
            raise covey.InputError(
                f"{file}: --view, --depth, --record, --times and --seed are for games, and it is a "
                "folder"
            )
        _draw_study(Path(file), output, look)
        return
    chosen = _checked_view(view, output)
    if times is not None:
        _require_view("--times", "snapshots", chosen)
        look["times"] = times
    if depth is not None:
        _require_view("--depth", "tree", chosen)
    source = read_scenario_or_game(file, seed)
    if chosen in ("plan", "tree"):
        _draw_plan(source, chosen, depth, output, record, look)
    else:
        _draw_game(source, chosen, output, record, look)


def _require_view(option: str, needed: View, chosen: View) -> None:
    if chosen != needed:
        raise covey.InputError(f"{option}: expected the view {needed}, got {chosen}")


def _look(title: str | None, size: float | None) -> dict[str, Any]:
    """Return what was said of the picture, as functions that draw take it."""
    from covey.model.validation import number  # only now, as it loads NumPy

    look: dict[str, Any] = {} if title is None else {"title": title}
    return look if size is None else look | {"width": number("--size", size, low=1.0, high=100.0)}


def _draw_study(folder: Path, output: Path, look: Mapping[str, Any]) -> None:
    from covey.views.kit.saving import STILLS  # only now, as it loads matplotlib

    check_output(output, STILLS, "a picture")
    print_saved(views.save(views.draw_study(covey.load_study(folder), **look), output))


def _checked_view(view: View | None, output: Path) -> View:
    """Choose the view by the output's ending, and raise InputError if they don't fit."""
    from covey.views.kit.saving import FILMS, STILLS  # only now, as it loads matplotlib

    suffix = output.suffix.lower()
    if view is None:
        check_output(output, [*STILLS, *FILMS], "a picture or a film")
    elif view == "animation":
        check_output(output, FILMS, "the view animation")
    else:
        check_output(output, STILLS, f"the view {view}")
    if suffix == ".mp4":
        views.require_video()
    return view or ("animation" if suffix in FILMS else "snapshots")


def _draw_plan(
    source: covey.Scenario | covey.Game,
    view: View,
    depth: int | None,
    output: Path,
    record: Path | None,
    look: Mapping[str, Any],
) -> None:
    """Draw the first plan of a scenario, or the plan that answers captures."""
    if record is not None:
        raise covey.InputError(f"--record: the view {view} plays no game; choose another --view")
    if not isinstance(source, covey.Scenario):
        raise covey.InputError(
            f"the view {view} needs a scenario, got the record of a game; the view snapshots shows "
            "with which plan it began"
        )
    if view == "tree":
        figure = views.draw_contingent(source.plan_contingent(depth), **look)
    else:
        figure = views.draw_plan(source.plan(), **look)
    print_saved(views.save(figure, output))


def _draw_game(
    source: covey.Scenario | covey.Game,
    view: View,
    output: Path,
    record: Path | None,
    look: Mapping[str, Any],
) -> None:
    """Draw a game; a scenario is played first, and the record saved before it is drawn."""
    if record is not None:
        check_output(record, [".parquet"], "the record of a game")
    game = source.simulate() if isinstance(source, covey.Scenario) else source
    if record is not None:
        covey.save_game(game, record)
        print_saved(record)
    if view == "animation":
        save_film(views.animate(game, **look), output)
    else:
        draw_view = views.draw_game if view == "game" else views.draw_snapshots
        print_saved(views.save(draw_view(game, **look), output))
