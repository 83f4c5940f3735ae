"""`covey yardstick`: strategies against the true value of the game of two evaders."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def yardstick(
    *,
    output: Annotated[
        Path, Parameter(name=["--output", "-o"], help="Folder for the tables and the picture.")
    ] = Path("results/yardstick"),
    pairs: Annotated[int, Parameter(help="Starts of each kind and couple of speeds.")] = 50,
    cells: Annotated[
        int, Parameter(help="Of the finest grid of the value; a quarter is computed first.")
    ] = 256,
    seed: Annotated[int, Parameter(help="Of the starts and the strategies.")] = 0,
) -> None:
    """Measure how close the evaders' strategies come to the true value of the game.

    For two evaders with unlimited turn rates and a pursuer that they see, dynamic programming gives
    the value that the best play on both sides leads to. Every strategy that needs no parameter
    plays from starts at random, and from pairs that are close to each other, against four
    pursuers; the least of its four survival times counts. Takes some minutes.

    Try:

        covey yardstick --pairs 5 --cells 64
    """
    from covey.cli.shared.outputs import check_folder
    from covey.cli.show.measuring import measure_all, print_yardstick, save_yardstick

    check_folder(output)
    measured = measure_all(pairs, cells, seed)
    print_yardstick(measured)
    save_yardstick(measured, output)
