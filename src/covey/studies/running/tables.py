"""The tables of a study: one row a game, and on request one row for every moment of every game.

Every column holds one number or word a row, so that pandas, polars and DuckDB read it without
help; where a team is smaller than the largest one, its last columns are null.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from covey.simulation.storage import columns_of
from covey.simulation.strategy import description
from covey.studies.design.study import GRID, Study
from covey.studies.running.games import StudyGame

if TYPE_CHECKING:
    import pyarrow as pa

_WORDS = ("sensing", "objective", "evaders", "pursuer")
_WHOLE = ("team_size",)
GAMES, MOMENTS = "games", "trajectories"


def games_table(study: Study, games: Iterable[StudyGame]) -> pa.Table:
    """Return the table of games: who started where, what was guaranteed, what came of it."""
    import pyarrow as pa

    played = list(games)
    size = max(study.team_size)
    cases = [_case_row(case) for case in study.cases]
    schema = _schema(size)
    columns: dict[str, list[Any]] = {name: [] for name in schema.names}
    for game in played:
        columns["game"].append(game.number)
        columns["start"].append(game.start)
        columns["case"].append(game.case)
        columns["seed"].append(game.origin.seed)
        columns["guarantee"].append(game.outcome.guarantee)
        columns["survival_time"].append(game.outcome.survival_time)
        columns["planned_value"].append(game.outcome.planned_value)
        columns["value"].append(game.outcome.value)
        for name, value in cases[game.case].items():
            columns[name].append(value)
        _captures(columns, game, size)
    return pa.table(columns, schema=schema)


def _captures(columns: dict[str, list[Any]], game: StudyGame, size: int) -> None:
    captured = game.outcome.capture_sequence.tolist()
    times = game.outcome.capture_times.tolist()
    places = game.origin.positions.tolist()
    headings = game.origin.headings.tolist()
    for k in range(size):
        columns[f"captured_{k}"].append(captured[k] if k < len(captured) else None)
        columns[f"capture_time_{k}"].append(times[k] if k < len(times) else None)
        x, y = places[k] if k < len(places) else (None, None)
        columns[f"evader_{k}_x"].append(x)
        columns[f"evader_{k}_y"].append(y)
        columns[f"evader_{k}_heading"].append(headings[k] if k < len(headings) else None)


def _case_row(case: Any) -> dict[str, Any]:
    row = case._asdict()
    for name in ("objective", "evaders", "pursuer"):
        row[name] = described_text(description(row[name]))
    return dict(row)


def described_text(strategy: Mapping[str, Any]) -> str:
    """Write the description of a strategy in one line: name (parameter = value, ...)."""
    parameters = ", ".join(f"{k} = {json.dumps(v)}" for k, v in strategy.items() if k != "name")
    return f"{strategy['name']} ({parameters})" if parameters else str(strategy["name"])


def _schema(size: int) -> pa.Schema:
    import pyarrow as pa

    kinds: dict[str, Any] = {"game": pa.int64(), "start": pa.int64(), "case": pa.int32()}
    for name in GRID:
        kinds[name] = pa.string() if name in _WORDS else pa.float64()
    for name in _WHOLE:
        kinds[name] = pa.int32()
    kinds["seed"] = pa.int64()
    for name in ("guarantee", "survival_time", "planned_value", "value"):
        kinds[name] = pa.float64()
    kinds |= {f"captured_{k}": pa.int32() for k in range(size)}
    kinds |= {f"capture_time_{k}": pa.float64() for k in range(size)}
    for k in range(size):
        kinds |= {f"evader_{k}_{part}": pa.float64() for part in ("x", "y", "heading")}
    return pa.schema(list(kinds.items()))


def moments_table(study: Study, games: Iterable[StudyGame]) -> pa.Table:
    """Return the courses of all games, one after the other, in single precision."""
    import pyarrow as pa

    size = max(study.team_size)
    tables = [_moments(game, size) for game in games if game.record is not None]
    return pa.concat_tables(tables)


def _moments(game: StudyGame, size: int) -> pa.Table:
    import pyarrow as pa

    record = game.record
    assert record is not None
    rows, columns = len(record.times), columns_of(record)
    arrays = {
        name: pa.array(columns[name].astype(np.float32))
        if name in columns
        else pa.nulls(rows, pa.float32())
        for name in _trajectory_columns(size)
    }
    return pa.table({"game": pa.array(np.full(rows, game.number)), **arrays})


def _trajectory_columns(size: int) -> list[str]:
    """Return the columns of a game's record that are kept, for teams of up to `size`."""
    alone = ["time", "guarantee", "disk_x", "disk_y", "disk_radius", "pursuer_x", "pursuer_y"]
    return alone + [f"evader_{k}_{part}" for k in range(size) for part in ("x", "y", "heading")]


def encoded(table: pa.Table) -> bytes:
    """Return a table as the bytes of a Parquet file; the same table gives the same bytes."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    sink = pa.BufferOutputStream()
    dense = [field.name for field in table.schema if field.type == pa.float32()]
    pq.write_table(
        table,
        sink,
        compression="zstd",
        use_dictionary=not dense,
        use_byte_stream_split=dense or False,
        write_page_checksum=True,
    )
    content: bytes = sink.getvalue().to_pybytes()
    return content


def decoded(content: bytes) -> pa.Table:
    """Return the table that a Parquet file holds; raises what pyarrow does if it is damaged."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    return pq.read_table(
        pa.BufferReader(content), use_threads=False, page_checksum_verification=True
    )
