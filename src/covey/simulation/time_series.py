"""The time series of a record: the part of a log, and the columns of a table, for each."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from covey.kernels.play.game import GameLog


class TimeSeries(NamedTuple):
    """A field of `Game` with one row at every update and every capture."""

    logged: Callable[[GameLog], Any]
    columns: Any  # names of the columns, nested as the numbers of one row are


def time_series(count: int) -> dict[str, TimeSeries]:
    """Return the time series of a game of `count` evaders, by field, in the order of the table."""
    team = range(count)
    return {
        "times": TimeSeries(lambda log: log.times, "time"),
        "guarantees": TimeSeries(lambda log: log.guarantees, "guarantee"),
        "assurances": TimeSeries(lambda log: np.full(len(log.times), math.inf), "assurance"),
        "disk_centers": TimeSeries(lambda log: log.pursuers[:, 2:4], ["disk_x", "disk_y"]),
        "disk_radii": TimeSeries(lambda log: log.pursuers[:, 4], "disk_radius"),
        "pursuer_positions": TimeSeries(
            lambda log: log.pursuers[:, :2], ["pursuer_x", "pursuer_y"]
        ),
        "evader_positions": TimeSeries(
            lambda log: log.evaders[:, :, :2], [[f"evader_{i}_x", f"evader_{i}_y"] for i in team]
        ),
        "evader_headings": TimeSeries(
            lambda log: log.evaders[:, :, 2], [f"evader_{i}_heading" for i in team]
        ),
        "evader_turns": TimeSeries(
            lambda log: log.evaders[:, :, 3], [f"evader_{i}_turn" for i in team]
        ),
        "critical_sequences": TimeSeries(
            lambda log: log.critical, [f"critical_sequence_{k}" for k in team]
        ),
        "pursuer_sequences": TimeSeries(
            lambda log: log.intended, [f"pursuer_sequence_{k}" for k in team]
        ),
    }
