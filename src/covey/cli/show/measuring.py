"""The parts of `covey yardstick`: the measurement, its table, its files."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from covey import views
from covey.cli.shared.outputs import print_saved, write_csv
from covey.model.validation import whole_number
from covey.studies.analysis.yardstick import SPEEDS, Change, Yardstick, YardstickRow, measure
from covey.views.charts.closeness import Closeness


def measure_all(pairs: int, cells: int, seed: int) -> list[Yardstick]:
    """Measure at all speeds, and say at which."""
    whole_number("pairs", pairs, low=1)
    whole_number("cells", cells, low=64)
    measured = []
    for speeds in SPEEDS:
        print(f"speeds {_couple(*speeds)}", file=sys.stderr, flush=True)
        measured.append(measure(speeds, pairs=pairs, cells=cells, seed=seed))
    return measured


def print_yardstick(measured: list[Yardstick]) -> None:
    """Print the survival times over the value, and how much the finest grid changed the value."""
    table = Table(box=SIMPLE_HEAD, pad_edge=False)
    for head in ("speeds", "pairs", "evaders", "mean", "least", "most", "known to"):
        table.add_column(head, justify="right", no_wrap=True)
    for yardstick in measured:
        changes = {change.pairs: change for change in yardstick.changes}
        for (speeds, pairs, evaders), shares in _shares(yardstick.rows).items():
            known = f"{100 * changes[pairs].mean:.1g} %"
            figures = (np.mean(shares), np.min(shares), np.max(shares))
            table.add_row(speeds, pairs, evaders, *(f"{each:.4f}" for each in figures), known)
    console = Console(highlight=False)
    console.print("survival time over the true value; by how much, on average, that is known:")
    console.print(table)


def save_yardstick(measured: list[Yardstick], folder: Path) -> None:
    """Save every game, the changes from grid to grid, and the picture."""
    scores = [score for each in measured for score in each.rows]
    write_csv(folder / "yardstick.csv", YardstickRow._fields, scores)
    changes = [change for each in measured for change in each.changes]
    write_csv(folder / "convergence.csv", Change._fields, changes)
    panels: dict[str, dict[str, dict[str, Closeness]]] = {}
    for (speeds, pairs, evaders), shares in _shares(scores).items():
        found = Closeness(float(np.mean(shares)), float(np.min(shares)))
        panels.setdefault(f"{pairs} pairs", {}).setdefault(evaders, {})[speeds] = found
    figure = views.draw_closeness(panels)
    for ending in (".png", ".svg", ".pdf"):
        views.save(figure, folder / f"yardstick{ending}")
    print_saved(folder / "yardstick.png")


def _shares(scores: list[YardstickRow]) -> dict[tuple[str, str, str], list[float]]:
    """Survival times over the value, by speeds, kind of pairs and strategy."""
    shares: dict[tuple[str, str, str], list[float]] = {}
    for score in scores:
        case = _couple(score.speed_1, score.speed_2), score.pairs, score.evaders
        shares.setdefault(case, []).append(score.survival_time / score.value)
    return shares


def _couple(speed_1: float, speed_2: float) -> str:
    return f"{speed_1:g}/{speed_2:g}"
