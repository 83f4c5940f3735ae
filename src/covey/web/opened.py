"""A record that somebody opens on the page: it may come from anywhere."""

from __future__ import annotations

from io import BytesIO

from covey.model import InputError
from covey.simulation import Game
from covey.simulation.storage import read_game

MOST_BYTES = 16 * 2**20
MOST_NUMBERS = 10**7
"""In the table once it is unpacked: a small file can hide a huge one."""


def opened_game(content: bytes) -> Game:
    """Return the game in a file, or raise InputError that says why there is none."""
    if len(content) > MOST_BYTES:
        raise InputError(
            f"record: expected at most {MOST_BYTES} bytes, got {len(content)}; draw it with "
            "`covey draw`"
        )
    numbers = _numbers(content)
    if numbers > MOST_NUMBERS:
        raise InputError(
            f"record: expected at most {MOST_NUMBERS} numbers, got {numbers}; draw it with "
            "`covey draw`"
        )
    return read_game(content, "record")


def _numbers(content: bytes) -> int:
    """How many numbers the file says it has; 0 if it is no such file, which its reader will say."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        metadata = pq.read_metadata(BytesIO(content))
    except (pa.ArrowException, OSError):
        return 0
    return int(metadata.num_rows) * int(metadata.num_columns)
