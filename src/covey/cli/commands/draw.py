"""`covey draw`: pictures and films of games and plans."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from covey.cli.shared.arguments import Seed

View = Literal["snapshots", "game", "plan", "animation"]


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
            "first plan, and the captures that it must expect. animation: a film. By default a "
            "film if the output is one, else snapshots."
        ),
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
        from covey.cli.show.comparison import draw_comparison
        from covey.model import InputError

        if (view, record, seed) != (None, None, None):
            raise InputError(f"{file}: --view, --record and --seed are for games; it is a folder")
        draw_comparison(Path(file), output)
        return
    from covey.cli.shared.sources import read_scenario_or_game
    from covey.cli.show.film import draw_view

    draw_view(read_scenario_or_game(file, seed), view, output, record)
