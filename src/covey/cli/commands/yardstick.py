"""`covey yardstick`: strategies against the true value of the game of two evaders."""

from __future__ import annotations

import sys
from pathlib import Path
from statistics import fmean
from typing import Annotated

from cyclopts import Parameter
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from covey import studies, views
from covey.cli.shared.outputs import results_folder, save_picture, write_csv


def yardstick(
    *,
    output: Annotated[
        Path | None,
        Parameter(
            name=["--output", "-o"],
            help="Folder for the tables and the picture; by default results/yardstick.",
        ),
    ] = None,
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
    folder = results_folder(output, "yardstick")
    measured = _measure_all(pairs, cells, seed)
    _print(measured)
    _save(measured, folder)


def _measure_all(pairs: int, cells: int, seed: int) -> list[studies.Yardstick]:
    """Measure at all speeds, and say at which."""
    # Only now, as they load NumPy.
    from covey.model.validation import whole_number
    from covey.studies.analysis.yardstick import SPEEDS, measure

    whole_number("pairs", pairs, low=1)
    whole_number("cells", cells, low=64)
    measured = []
    for speeds in SPEEDS:
        print(f"speeds {_speeds(*speeds)}", file=sys.stderr, flush=True)
        measured.append(measure(speeds, pairs=pairs, cells=cells, seed=seed))
    return measured


def _print(measured: list[studies.Yardstick]) -> None:
    """Print survival times over the value, and by how much the finest grid changed the value."""
    table = Table(box=SIMPLE_HEAD, pad_edge=False)
    for head in ("speeds", "pairs", "evaders", "mean", "least", "most", "known to"):
        table.add_column(head, justify="right", no_wrap=True)
    for game in measured:
        changes = {change.pairs: change for change in game.changes}
        for (speeds, pairs, evaders), shares in _shares(game.rows).items():
            known = f"{100 * changes[pairs].mean:.1g} %"
            figures = (fmean(shares), min(shares), max(shares))
            table.add_row(speeds, pairs, evaders, *(f"{each:.4f}" for each in figures), known)
    console = Console(highlight=False)
    console.print("survival time over the true value; by how much, on average, that is known:")
    console.print(table)


def _save(measured: list[studies.Yardstick], folder: Path) -> None:
    """Save every game, the changes from grid to grid, and the picture."""
    rows = [row for each in measured for row in each.rows]
    write_csv(folder / "yardstick.csv", studies.YardstickRow._fields, rows)
    changes = [change for each in measured for change in each.changes]
    write_csv(folder / "convergence.csv", studies.Change._fields, changes)
    panels: dict[str, dict[str, dict[str, views.Closeness]]] = {}
    for (speeds, pairs, evaders), shares in _shares(rows).items():
        found = views.Closeness(fmean(shares), min(shares))
        panels.setdefault(f"{pairs} pairs", {}).setdefault(evaders, {})[speeds] = found
    save_picture(views.draw_closeness(panels), folder, "yardstick")


def _shares(rows: list[studies.YardstickRow]) -> dict[tuple[str, str, str], list[float]]:
    """Return survival times over the value, by speeds, kind of pairs and strategy."""
    shares: dict[tuple[str, str, str], list[float]] = {}
    for row in rows:
        case = _speeds(row.speed_1, row.speed_2), row.pairs, row.evaders
        shares.setdefault(case, []).append(row.survival_time / row.value)
    return shares


def _speeds(speed_1: float, speed_2: float) -> str:
    return f"{speed_1:g}/{speed_2:g}"
