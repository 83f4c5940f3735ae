"""The tables of a study: one row a game, and on request one row a time of every game.

Every column holds one number or word a row, so that pandas, polars and DuckDB read the tables
directly. Where a team is smaller than the study's largest, the columns of its missing evaders are
null.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from covey.simulation import Game
from covey.simulation.strategy import description
from covey.studies.design.case import GRID, Case
from covey.studies.design.study import Study
from covey.studies.running.games import StudyGame

if TYPE_CHECKING:
    import pyarrow as pa

GAMES, TRAJECTORIES = "games", "trajectories"
_TEXTS = ("sensing", "objective", "evaders", "pursuer")


def games_table(study: Study, games: Iterable[StudyGame]) -> pa.Table:
    """Return the table of games: their starts, guarantees, captures and values."""
    import pyarrow as pa

    cases = [_case_columns(case) for case in study.cases]
    rows = [cases[game.case] | _game_columns(game) for game in games]
    return pa.Table.from_pylist(rows, schema=schema(GAMES, max(study.team_size)))


def _case_columns(case: Case) -> dict[str, Any]:
    row = case._asdict()
    for name in ("objective", "evaders", "pursuer"):
        row[name] = described_text(description(row[name]))
    return row


def _game_columns(game: StudyGame) -> dict[str, Any]:
    outcome, origin = game.outcome, game.origin
    row = {
        "game": game.number,
        "start": game.start,
        "case": game.case,
        "seed": origin.seed,
        "guarantee": outcome.guarantee,
        "survival_time": outcome.survival_time,
        "planned_value": outcome.planned_value,
        "value": outcome.value,
    }
    row |= {f"captured_{k}": i for k, i in enumerate(outcome.capture_sequence.tolist())}
    row |= {f"capture_time_{k}": time for k, time in enumerate(outcome.capture_times.tolist())}
    for i, (x, y) in enumerate(origin.positions.tolist()):
        row |= {f"evader_{i}_x": x, f"evader_{i}_y": y}
    row |= {f"evader_{i}_heading": h for i, h in enumerate(origin.headings.tolist())}
    return row


def described_text(strategy: Mapping[str, Any]) -> str:
    """Write the description of a strategy in one line: name (parameter = value, ...)."""
    parameters = ", ".join(f"{k} = {json.dumps(v)}" for k, v in strategy.items() if k != "name")
    return f"{strategy['name']} ({parameters})" if parameters else str(strategy["name"])


def labels(strategies: Sequence[dict[str, Any]]) -> list[str]:
    """Return the names of strategies, with parameters where several have the same name."""
    names = [strategy["name"] for strategy in strategies]
    return [
        name if names.count(name) == 1 else described_text(strategy)
        for name, strategy in zip(names, strategies, strict=True)
    ]


def schema(kind: str, size: int) -> pa.Schema:
    """Return the columns of `GAMES` or `TRAJECTORIES` of teams of up to `size`."""
    import pyarrow as pa

    if kind == TRAJECTORIES:
        names = _trajectory_columns(size)
        return pa.schema([("game", pa.int64()), *((name, pa.float32()) for name in names)])
    types: dict[str, Any] = {"game": pa.int64(), "start": pa.int64(), "case": pa.int32()}
    types |= {name: pa.string() if name in _TEXTS else pa.float64() for name in GRID}
    types |= {"team_size": pa.int32(), "seed": pa.int64()}
    for name in ("guarantee", "survival_time", "planned_value", "value"):
        types[name] = pa.float64()
    types |= {f"captured_{k}": pa.int32() for k in range(size)}
    types |= {f"capture_time_{k}": pa.float64() for k in range(size)}
    for i in range(size):
        types |= {f"evader_{i}_{part}": pa.float64() for part in ("x", "y", "heading")}
    return pa.schema(list(types.items()))


def trajectories_table(study: Study, games: Iterable[StudyGame]) -> pa.Table:
    """Return the trajectories of all recorded games, one game after the other, in float32."""
    import pyarrow as pa

    size = max(study.team_size)
    return pa.concat_tables(
        _trajectory(game.number, game.record, size) for game in games if game.record is not None
    )


def _trajectory(number: int, record: Game, size: int) -> pa.Table:
    import pyarrow as pa

    rows, columns = len(record.times), record.columns()
    arrays = {
        name: pa.array(columns[name].astype(np.float32))
        if name in columns
        else pa.nulls(rows, pa.float32())
        for name in _trajectory_columns(size)
    }
    return pa.table({"game": pa.array(np.full(rows, number)), **arrays})


def _trajectory_columns(size: int) -> list[str]:
    """Return the columns of a game's record that are kept, for teams of up to `size`."""
    alone = ["time", "guarantee", "disk_x", "disk_y", "disk_radius", "pursuer_x", "pursuer_y"]
    return alone + [f"evader_{k}_{part}" for k in range(size) for part in ("x", "y", "heading")]


def encoded(table: pa.Table) -> bytes:
    """Return a table as the bytes of a Parquet file. Equal tables give equal bytes."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    sink = pa.BufferOutputStream()
    floats = [field.name for field in table.schema if field.type == pa.float32()]
    pq.write_table(
        table,
        sink,
        compression="zstd",
        use_dictionary=not floats,
        use_byte_stream_split=floats or False,
        write_page_checksum=True,
    )
    content: bytes = sink.getvalue().to_pybytes()
    return content
