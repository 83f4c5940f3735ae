"""`covey reproduce`: the paper's figures and what they tell, from scratch."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def reproduce(
    *,
    output: Annotated[
        Path,
        Parameter(name=["--output", "-o"], help="Folder for the report, the figures, the games."),
    ] = Path("results"),
    starts: Annotated[
        int | None,
        Parameter(help="Starts of Figs. 4 and 5: 500, as in the paper, or fewer for a quick look."),
    ] = None,
    workers: Annotated[
        int | None,
        Parameter(help="Processes on this machine; by default as many as it has cores."),
    ] = None,
) -> None:
    """Reproduce the paper: Figs. 1 to 5, and a report that sets our figures beside its claims.

    Plays the game of Fig. 3 and the studies of Figs. 4 and 5, 18 000 games in all. report.md tells
    what came out; the figures stand beside it as .png, .svg and .pdf, and every game is in the
    folders fig4 and fig5. A run that was stopped goes on where it was.

    Try:

        covey reproduce --output results
    """
    from covey.cli.shared.outputs import check_folder
    from covey.cli.show.reproduction import reproduce_game, reproduce_studies, write_report

    check_folder(output)
    game = reproduce_game(output)
    fig4, fig5 = reproduce_studies(output, starts, workers)
    write_report(output, game, fig4, fig5)
