"""Parts of a study's tables, checked whole when they are read.

The same check decides which chunks a run keeps and which parts are shown, so a part that is refused
is a part that the next run plays anew.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from covey.model.validation import Floats
from covey.simulation.parquet import read_table
from covey.studies.running.tables import GAMES, schema

if TYPE_CHECKING:
    import pyarrow as pa

_OF_OBJECTIVES = {"objective", "planned_value", "value"}
_ADDED = {*_OF_OBJECTIVES, "turn_radius"}
"""Columns that the tables of early versions lack: they knew one objective, and no radii."""


class Extent(NamedTuple):
    """The games of a part."""

    first: int  # number of the first game
    last: int  # number of the game after the last one
    cases: int  # games of each start
    size: int  # evaders in the largest team of the study
    one_objective: bool  # whether all games are about the last capture


class DamagedPartError(Exception):
    """A part that isn't a table of its games; the message says why."""


def read_part(content: bytes, kind: str, extent: Extent) -> pa.Table:
    """Return the table in a file of `GAMES` or `TRAJECTORIES`, or raise DamagedPartError."""
    import pyarrow as pa

    try:
        table = read_table(content)
        _require_columns(table, kind, extent)  # reads the names, which may be no UTF-8
    except (pa.ArrowException, OSError, ValueError) as error:
        raise DamagedPartError("its bytes are no table") from error
    if kind == GAMES:
        _require_games(table, extent)
    else:
        _require_trajectories(table, extent)
    return table


def _require(holds: Any, wanted: str) -> None:
    if not np.all(holds):
        raise DamagedPartError(f"expected {wanted}")


def _require_columns(table: pa.Table, kind: str, extent: Extent) -> None:
    may_lack = _ADDED if extent.one_objective else _ADDED - _OF_OBJECTIVES
    for field in schema(kind, extent.size):
        there = field.name in table.column_names
        _require(there or field.name in may_lack, f"a column {field.name}")
        same = not there or table.schema.field(field.name).type == field.type
        _require(same, f"{field.type} in the column {field.name}")


def _require_games(table: pa.Table, extent: Extent) -> None:
    """Check that each row is a game of its number, and that its captures agree."""
    numbers, size = np.arange(extent.first, extent.last), extent.size
    _require(len(table) == len(numbers), f"{len(numbers)} games, got {len(table)}")
    start, case = np.divmod(numbers, extent.cases)
    for name, wanted in (("game", numbers), ("start", start), ("case", case)):
        _require(_column(table, name) == wanted, f"the number of each {name}, in order")
    teams, guarantees = _column(table, "team_size"), _column(table, "guarantee")
    _require((teams >= 1) & (teams <= size), f"teams of 1 to {size}")
    _require(np.isfinite(guarantees) & (guarantees >= 0.0), "finite guarantees")
    order = np.column_stack([_column(table, f"captured_{k}") for k in range(size)])
    times = np.column_stack([_column(table, f"capture_time_{k}") for k in range(size)])
    captures = np.isfinite(times).sum(axis=1)
    captured = np.arange(size) < captures[:, None]
    _require((np.isfinite(order) == captured) & (np.isfinite(times) == captured), "every capture")
    each_once = (order[:, :, None] == np.arange(size)).sum(axis=1) <= 1
    _require(each_once & (~captured | (order < teams[:, None])), "each evader once")
    known = np.where(captured, times, np.inf)
    _require((known[:, 1:] >= known[:, :-1]) & (known[:, :1] >= 0.0), "captures in order of time")
    last = np.where(captures == teams, known[np.arange(len(teams)), captures - 1], np.inf)
    _require(_column(table, "survival_time") == last, "the time of the last capture")
    if "value" in table.column_names:
        values = np.isfinite(_column(table, "value"))
        _require(values == np.isfinite(last), "finite values of games that came to their end")


def _require_trajectories(table: pa.Table, extent: Extent) -> None:
    """Check that there are rows of each game, in the order of their times."""
    games, times = _column(table, "game"), _column(table, "time")
    wanted = np.arange(extent.first, extent.last)
    in_order = np.array_equal(np.unique(games), wanted) and np.all(np.diff(games) >= 0)
    _require(in_order, "the trajectory of each game")
    # Compared, not subtracted: in float32 the longest times are infinite.
    _require((times[1:] >= times[:-1]) | (games[1:] > games[:-1]), "times in order")


def _column(table: pa.Table, name: str) -> Floats:
    """Return a column in double precision; a missing number is NaN."""
    values: Floats = table[name].to_numpy().astype(np.float64)
    return values
