"""Parquet files, read by the calling thread alone."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pyarrow as pa


def read_table(source: Path | bytes) -> pa.Table:
    """Return the table of a file, or of its content.

    Raises pyarrow's errors if the content is damaged, and ValueError if columns share a name.

    `pyarrow.parquet.read_table` reads in other threads, whatever `use_threads` says. When the
    program ends, such a thread may still hold the content, and Python then aborts the program.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    opened = pa.BufferReader(source) if isinstance(source, bytes) else source
    with pq.ParquetFile(opened, page_checksum_verification=True) as file:
        table = file.read(use_threads=False)
    if len(set(table.column_names)) < table.num_columns:
        raise ValueError("expected a name of its own for each column")
    return table
