"""`covey draw`: pictures and films of games and plans."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

import covey
from covey import views
from covey.cli.shared.arguments import Seed
from covey.cli.shared.outputs import check_output, print_saved
from covey.cli.shared.sources import read_scenario_or_game
from covey.cli.show.comparison import draw_comparison
from covey.cli.show.film import save_film

View = Literal["snapshots", "game", "plan", "tree", "animation"]


def draw(
    file: Annotated[
        str,
        Parameter(
            name="FILE",
            help="Record of a game, or a scenario, which is played first: its file, or the name "
            "of one that comes with covey. Or the folder with the results of a study that compares "
            "teams or objectives.",
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
            help="snapshots: four moments of the game. game: all paths and captures. plan: the "
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
    seed: Seed = None,
) -> None:
    """Draw a game or a plan.

    Try:

        covey draw game.parquet --output game.png
        covey draw fig3 --view plan --output plan.pdf
        covey draw fig3 --record game.parquet --output game.gif
        covey draw results/tournament --output tournament.png
    """
    if Path(file).is_dir():
        if (view, depth, record, seed) != (None, None, None, None):
            raise covey.InputError(
                f"{file}: --view, --depth, --record and --seed are for games; it is a folder"
            )
        draw_comparison(Path(file), output)
        return
    if depth is not None and view != "tree":
        raise covey.InputError(
            "--depth: expected --view tree beside it; no other view shows answers to captures"
        )
    source, chosen = read_scenario_or_game(file, seed), _checked_view(view, output)
    if chosen in ("plan", "tree"):
        _draw_plan(source, chosen, depth, output, record)
    else:
        _draw_game(source, chosen, output, record)


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
        figure = views.draw_contingent(source.plan_contingent(depth))
    else:
        figure = views.draw_plan(source.team, source.disk, source.plan())
    print_saved(views.save(figure, output))


def _draw_game(
    source: covey.Scenario | covey.Game, view: View, output: Path, record: Path | None
) -> None:
    """Draw a game; a scenario is played first, and the record saved before it is drawn."""
    if record is not None:
        check_output(record, [".parquet"], "the record of a game")
    game = source.simulate() if isinstance(source, covey.Scenario) else source
    if record is not None:
        covey.save_game(game, record)
        print_saved(record)
    if view == "animation":
        save_film(game, output)
    else:
        figure = views.draw_game(game) if view == "game" else views.draw_snapshots(game)
        print_saved(views.save(figure, output))
