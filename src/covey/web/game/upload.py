"""A record that a person opens on the page. It may come from anywhere, so it isn't trusted."""

from __future__ import annotations

from io import BytesIO

from covey.model import InputError
from covey.simulation.storage import read_game
from covey.web.game.game_json import film

MOST_BYTES = 16 * 2**20
MOST_NUMBERS = 10**7
"""In the unpacked table: a small file can hold a huge table."""

_ONE_NUMBER = {"BOOLEAN", "INT32", "INT64", "FLOAT", "DOUBLE"}
"""Parquet's types of a column of which an entry can't be huge."""


def read_upload(content: bytes) -> str:
    """Return the message that replays the game in a file, or say in an InputError what is wrong."""
    for kind, most, size in (
        ("bytes", MOST_BYTES, len(content)),
        ("numbers", MOST_NUMBERS, _numbers(content)),
    ):
        if size > most:
            raise InputError(
                f"record: expected at most {most} {kind}, got {size}; draw it with `covey draw`"
            )
    game = read_game(content, "record")
    try:
        return film(game, "opened")  # a nan is an error
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise InputError(f"record: it contradicts itself: {error}") from error


def _numbers(content: bytes) -> int:
    """Return the number of entries that a file declares; 0 if `read_game` will refuse the file.

    Raise InputError if an entry can be more than a number.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        metadata = pq.read_metadata(BytesIO(content))
    except (pa.ArrowException, OSError, ValueError):
        return 0
    for k in range(metadata.num_columns):
        column = metadata.schema.column(k)
        if column.physical_type not in _ONE_NUMBER or column.max_repetition_level:
            raise InputError(
                f"record: expected one number a row in every column, got others in "
                f"{column.path[:40]!r}; save a game anew"
            )
    return int(metadata.num_rows) * int(metadata.num_columns)
