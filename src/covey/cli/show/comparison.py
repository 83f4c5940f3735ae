"""The scores of a study: a table on the screen for each group."""

from __future__ import annotations

import math

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from covey import studies

_WIDEST = 36
"""Letters of a row's name in one line."""


def print_comparison(console: Console, compared: studies.Comparison) -> None:
    """Print the means over the team sizes, relative to the first row of each group."""
    overall = [score for score in compared.ratios if score.team_size is None]
    for group in dict.fromkeys(score.group for score in overall):
        chosen = [score for score in overall if score.group == group]
        console.print(_table(group, compared.rows, chosen))
    sizes = dict.fromkeys(str(score.team_size) for score in compared.ratios if score.team_size)
    console.print(
        f"{compared.label[0].upper()}{compared.label[1:]}, from the same {overall[0].played} "
        f"starts, ± 95 % confidence; mean over teams of {', '.join(sizes)}."
    )
    if any(score.starts < score.played for score in overall):
        console.print("* Without the starts of which a game was stopped with evaders alive.")


def _table(title: str, rows: str, chosen: list[studies.PairedRatio]) -> Table:
    columns = list(dict.fromkeys(score.column for score in chosen))
    cells = {(score.row, score.column): _cell(score) for score in chosen}
    table = Table(
        title=title, title_justify="left", box=SIMPLE_HEAD, pad_edge=False, padding=(0, 0, 0, 0)
    )
    table.add_column(rows, max_width=_WIDEST, overflow="fold")
    for column in columns:
        table.add_column(column.replace("-", " "), justify="right")
    for row in dict.fromkeys(score.row for score in chosen):
        table.add_row(row, *(cells[row, column] for column in columns))
    return table


def _cell(score: studies.PairedRatio) -> str:
    value, error = score.relative
    if math.isnan(value):
        return "–*"  # fewer than two starts of which both games ended
    text = f"{value:.3f}" if error == 0.0 else f"{value:.3f} ±{error:.3f}".replace("±0", "±")
    return text + ("*" if score.starts < score.played else "")
