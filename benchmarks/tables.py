"""What was measured, as rows: times, ratios, and how often a method came to the same value."""

from __future__ import annotations

import csv
import math
from typing import NamedTuple

import numpy as np

from peers.peer import SAME
from rounds import REFERENCE


class Row(NamedTuple):
    """One method at one size and task; times in microseconds, then numbers of games.

    Methods start from the same turns, but may climb to different local maxima; `ratio`, to this
    planner compiled, is the median over the games in which both reach the same value.
    """

    size: int
    task: str
    method: str
    games: int
    median: float
    percentile_99: float
    ratio: float
    equal: int
    better: int
    worse: int
    settled: int  # ended in a local maximum


def rows(solves):
    """Return a `Row` for each method and task of one size, in the order in which they ran."""
    return [_row(solves, *which) for which in dict.fromkeys((s.task, s.method) for s in solves)]


def _row(solves, task, method):
    own = [s for s in solves if (s.task, s.method) == (task, method)]
    ours = {s.game: s for s in solves if (s.task, s.method) == (task, REFERENCE)}
    met = [(s, ours[s.game]) for s in own if s.game in ours]
    times = 1e6 * np.array([s.seconds for s in own])
    ratios = np.array([s.seconds / our.seconds for s, our in met])
    gains = np.array([s.value / our.value - 1.0 for s, our in met])
    equal = np.abs(gains) <= SAME
    return Row(
        own[0].size,
        task,
        method,
        len(own),
        float(np.median(times)),
        float(np.quantile(times, 0.99)),
        float(np.median(ratios[equal])) if equal.any() else math.nan,
        int(equal.sum()),
        int((gains > SAME).sum()),
        int((gains < -SAME).sum()),
        sum(s.settled for s in own),
    )


def write_csv(path, records):
    """Write named tuples of one kind to a file."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(records[0]._fields)
        writer.writerows(records)


def markdown(records):
    """Return named tuples of one kind as a table."""
    cells = [[_cell(value) for value in record] for record in records]
    head = [name.replace("_", " ") for name in records[0]._fields]
    widths = [max(map(len, column)) for column in zip(head, *cells, strict=True)]
    lines = [head, ["-" * (width - 1) + ":" for width in widths], *cells]
    return "\n".join(
        "| "
        + " | ".join(cell.rjust(width) for cell, width in zip(line, widths, strict=True))
        + " |"
        for line in lines
    )


def _cell(value):
    if isinstance(value, float):
        return "" if math.isnan(value) else f"{value:.3g}" if abs(value) < 1e3 else f"{value:,.0f}"
    return str(value)
