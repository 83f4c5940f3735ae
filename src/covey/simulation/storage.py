"""A game's record as one Parquet file, without loss.

A row of the record is a row of the table; what belongs to the whole game (team, disk, strategies,
captures) is JSON in the table's metadata, under the key "covey".

Every column holds one number a row: `time`, `disk_x`, `evader_0_x`, `critical_sequence_0`, ...
Columns of lists would be fewer, but pandas makes Python objects of them, DuckDB and polars need
their list functions for them, and none of the three can plot or filter them by name.
"""

from __future__ import annotations

import json
import math
import os
import zlib
from collections.abc import Mapping
from dataclasses import fields
from importlib.metadata import version
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from covey.model import InputError, LastCapture, PursuerDisk, Team
from covey.model.validation import Floats, Ints, shown
from covey.simulation.consistency import require_consistent
from covey.simulation.files import whole_file
from covey.simulation.parquet import read_table
from covey.simulation.record import Game, GameStatus
from covey.simulation.time_series import time_series

FORMAT = 1
"""Number of this layout; a reader refuses any other, as it can't know what differs."""

_KEY = b"covey"
_CHECKSUM_KEY = b"covey_crc32"
_PARQUET_BEGINS = b"PAR1"


def save_game(game: Game, path: str | os.PathLike[str]) -> None:
    """Save the record of a game as one Parquet file.

    The file is written whole or not at all, and replaces one of the same name. Its folder must be
    there.

    Parameters
    ----------
    game
        What `simulate` returned.
    path
        Where to, `game.parquet` for example.

    Raises
    ------
    OSError
        If the file can't be written; its `strerror` says why.

    Notes
    -----
    Any reader of Parquet files finds the columns:
    `pandas.read_parquet("game.parquet").plot("evader_0_x", "evader_0_y")` draws a path.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> import tempfile
    >>> from pathlib import Path
    >>> game = covey.simulate(team, disk, update_time=0.1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     covey.save_game(game, Path(folder) / "game.parquet")
    ...     again = covey.load_game(Path(folder) / "game.parquet")
    ...
    >>> again.survival_time == game.survival_time
    True
    """
    with whole_file(path) as file:
        write_game(game, file)


def write_game(game: Game, file: BinaryIO) -> None:
    """Write what `save_game` saves to a file that is open, or a buffer."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    header = _header(game)
    table = pa.table({name: pa.array(column) for name, column in game.columns().items()})
    notes = {_KEY: header, _CHECKSUM_KEY: _checksum(header, table)}
    # Neighbouring floats share their high bytes, which a split by byte lays side by side.
    pq.write_table(
        table.replace_schema_metadata(notes),
        file,
        compression="zstd",
        use_dictionary=False,
        use_byte_stream_split=True,
    )


def load_game(path: str | os.PathLike[str]) -> Game:
    """Load the record of a game that `save_game` wrote.

    Parameters
    ----------
    path
        The file.

    Returns
    -------
    Game
        Equal to the saved one to the last bit.

    Raises
    ------
    InputError
        If there is no such file, it isn't a record of a game, is damaged, holds numbers that no
        game by the rules has, or comes from another version of the format.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> import tempfile
    >>> from pathlib import Path
    >>> game = covey.simulate(team, disk, update_time=0.1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     covey.save_game(game, Path(folder) / "game.parquet")
    ...     again = covey.load_game(Path(folder) / "game.parquet")
    ...
    >>> again.capture_sequence.tolist() == game.capture_sequence.tolist()
    True
    """
    source = Path(path)
    try:
        content = source.read_bytes()
    except OSError as error:
        raise InputError(f"{source}: can't be read: {error.strerror}") from error
    return read_game(content, str(source))


def read_game(content: bytes, name: str) -> Game:
    """Return the record in the bytes of a file that `save_game` wrote, or raise InputError.

    The errors call the file `name`.
    """
    if not content.startswith(_PARQUET_BEGINS):
        raise InputError(f"{name}: expected the record of a game, got a file that isn't Parquet")
    try:
        game = _game(*_read(content))
        require_consistent(game)
    except _NotARecordError as error:
        raise InputError(f"{name}: {error}") from None
    except InputError as error:
        raise InputError(f"{name}: it contradicts itself: {error}; simulate anew") from None
    except Exception as error:  # whatever a damaged file makes of its readers
        raise InputError(f"{name}: the record is damaged or cut off; simulate anew") from error
    return game


def is_parquet(path: str | os.PathLike[str]) -> bool:
    """Return whether there is a Parquet file, by its first bytes."""
    try:
        with Path(path).open("rb") as file:
            return file.read(len(_PARQUET_BEGINS)) == _PARQUET_BEGINS
    except OSError:
        return False


class _NotARecordError(Exception):
    """A sound Parquet file that isn't a record, or isn't one for this version."""


def _header(game: Game) -> bytes:
    header = {
        "format": FORMAT,
        "version": version("covey"),
        "team": {field.name: getattr(game.team, field.name) for field in fields(Team)},
        "disk": {field.name: getattr(game.disk, field.name) for field in fields(PursuerDisk)},
        "sensing": game.sensing,
        "update_time": game.update_time,
        "seed": game.seed,
        "objective": game.objective,
        "strategies": game.strategies,
        "status": game.status.name,
        **game.outcome()._asdict(),
    }
    return json.dumps(_plain(header), allow_nan=False).encode()


def _checksum(header: bytes, table: Any) -> bytes:
    """Cover every number of the record: Parquet's own checksums leave out the metadata."""
    result = zlib.crc32(header)
    for name in table.column_names:
        result = zlib.crc32(name.encode() + table.column(name).to_numpy().tobytes(), result)
    return str(result).encode()


def _read(content: bytes) -> tuple[dict[str, Any], Any]:
    table = read_table(content)
    notes = table.schema.metadata or {}
    if _KEY not in notes:
        raise _NotARecordError(
            "expected the record of a game, got a Parquet file of something else"
        )
    header = json.loads(notes[_KEY], object_hook=_number)
    if header["format"] != FORMAT:
        raise _NotARecordError(
            f"written by covey {shown(header['version'])} in record format "
            f"{shown(header['format'])}, and this covey {version('covey')} reads format {FORMAT}; "
            f"use that covey, or simulate anew"
        )
    if notes[_CHECKSUM_KEY] != _checksum(notes[_KEY], table):
        raise ValueError("checksum")
    return header, table


def _game(header: Mapping[str, Any], table: Any) -> Game:
    team = Team(**header["team"])
    arrays: dict[str, Any] = {}
    for field, series in time_series(len(team)).items():
        names = np.array(series.columns)
        flat = np.column_stack([_column(table, name) for name in names.ravel()])
        arrays[field] = flat.reshape(-1, *names.shape)
    return Game(
        team=team,
        disk=PursuerDisk(**header["disk"]),
        sensing=header["sensing"],
        update_time=header["update_time"],
        seed=header["seed"],
        objective=header.get("objective", LastCapture().describe()),
        strategies=header["strategies"],
        status=GameStatus[header["status"]],
        guarantee=header["guarantee"],
        survival_time=header["survival_time"],
        planned_value=header.get("planned_value", header["guarantee"]),
        value=header.get("value", header["survival_time"]),
        capture_sequence=np.array(header["capture_sequence"], dtype=np.int64),
        capture_times=np.array(header["capture_times"], dtype=np.float64),
        **arrays,
    )


def _column(table: Any, name: str) -> Floats | Ints:
    """Return a column (T,); records of earlier versions have no assurances."""
    if name == "assurance" and name not in table.column_names:
        return np.full(len(table), math.inf)
    column: Floats | Ints = table.column(name).to_numpy()
    if column.dtype not in (np.float64, np.int64):
        raise ValueError(f"{name}: numbers of the type {column.dtype}")
    return column


def _plain(value: object) -> object:
    """Turn `value` into what JSON can say.

    A float that isn't finite becomes {"float": "inf"}: bare `Infinity` is no JSON, and other
    readers than Python's refuse it.
    """
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, float) and not math.isfinite(value):
        return {"float": str(value)}
    if isinstance(value, Mapping):
        return {str(key): _plain(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part) for part in value]
    if value is None or isinstance(value, str | int | float):
        return value
    # A parameter of somebody's own strategy. A game isn't lost for want of a format for it.
    return repr(value)


def _number(table: dict[str, Any]) -> object:
    return float(table["float"]) if table.keys() == {"float"} else table
