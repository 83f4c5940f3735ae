"""What was measured, as rows: times, ratios, and how often a method came to the same value."""

from __future__ import annotations

import csv
from typing import NamedTuple

import numpy as np

from rounds import REFERENCE, SAME


class Agreement(NamedTuple):
    """In how many games a method came to the same value, a better one, a worse one.

    Both start from the same turns, but may climb to different local maxima.
    """

    equal: int
    better: int
    worse: int


class Row(NamedTuple):
    """One method at one size and task; times in microseconds, ratios to this planner."""

    size: int
    task: str
    method: str
    games: int
    median: float
    percentile_99: float
    ratio: float  # median over the games in which both reach the same value
    equal: int
    better: int
    worse: int


def agreement(solves, task, method):
    """Compare a method's values with those of this planner."""
    gains = np.array([gain for _, gain in _compared(solves, task, method)])
    better, worse = int((gains > SAME).sum()), int((gains < -SAME).sum())
    return Agreement(len(gains) - better - worse, better, worse)


def rows(solves):
    """Return a `Row` for each method and task of one size, in the order in which they ran."""
    return [
        _row(solves, task, method)
        for task, method in dict.fromkeys((s.task, s.method) for s in solves)
    ]


def _row(solves, task, method):
    own = [s for s in solves if (s.task, s.method) == (task, method)]
    times = 1e6 * np.array([s.seconds for s in own])
    ratios = [ratio for ratio, gain in _compared(solves, task, method) if abs(gain) <= SAME]
    return Row(
        own[0].size,
        task,
        method,
        len(own),
        float(np.median(times)),
        float(np.quantile(times, 0.99)),
        float(np.median(ratios)) if ratios else float("nan"),
        *agreement(solves, task, method),
    )


def _compared(solves, task, method):
    """For each game that both played: ratio of the times, relative gain in value."""
    ours = {s.game: s for s in solves if (s.task, s.method) == (task, REFERENCE)}
    return [
        (s.seconds / ours[s.game].seconds, s.value / ours[s.game].value - 1.0)
        for s in solves
        if (s.task, s.method) == (task, method) and s.game in ours
    ]


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
        return "" if value != value else f"{value:.3g}" if abs(value) < 1e3 else f"{value:,.0f}"
    return str(value)
