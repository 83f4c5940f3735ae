"""Mutations of Parquet files: of their columns, of the JSON beside them, and of plain bytes."""

from __future__ import annotations

import json
from contextlib import suppress

import pyarrow as pa
import pyarrow.parquet as pq
from hypothesis import strategies as st

from fuzz.mutation import NUMBERS, TEXTS, damaged, edited


@st.composite
def edited_table(draw, content, note=None):
    """Draw a file like `content` with other columns; `note` names the metadata that is JSON."""
    table = pq.read_table(pa.BufferReader(content), use_threads=False)
    for _ in range(draw(st.integers(0 if note else 1, 3))):
        table = _edit_table(draw, table)
    if note and draw(st.booleans()):
        header = draw(edited(json.loads(table.schema.metadata[note]), ()))
        notes = {**table.schema.metadata, note: json.dumps(header).encode(errors="surrogatepass")}
        table = table.replace_schema_metadata(notes)
    return table


def _edit_table(draw, table):
    if not table.num_columns:
        return table
    at = draw(st.integers(0, table.num_columns - 1))
    name, column = table.column_names[at], table.column(at)
    match draw(st.sampled_from(("number", "remove", "rename", "kind", "rows", "column"))):
        case "number" if table.num_rows:
            items, row = column.to_pylist(), draw(st.integers(0, table.num_rows - 1))
            items[row] = draw(st.sampled_from((*NUMBERS, *TEXTS, None, *items)) | st.floats())
            with suppress(pa.ArrowException, OverflowError):  # the column can't hold it
                return table.set_column(at, name, pa.array(items, column.type))
        case "remove":
            return table.remove_column(at)
        case "rename":
            return table.set_column(at, draw(st.sampled_from((*table.column_names, "x"))), column)
        case "kind":
            kind = draw(st.sampled_from((pa.string(), pa.float32(), pa.int8(), pa.bool_())))
            with suppress(pa.ArrowException):
                return table.set_column(at, name, column.cast(kind))
        case "rows":
            return table.slice(*draw(st.tuples(*2 * (st.integers(0, table.num_rows),))))
        case "column":
            other = draw(st.integers(0, table.num_columns - 1))
            return table.set_column(at, name, table.column(other))
    return table


def encoded(table):
    """Return the bytes of a table's file."""
    sink = pa.BufferOutputStream()
    pq.write_table(table, sink)
    return sink.getvalue().to_pybytes()


def parquet_cases(contents, edits):
    """Draw files like `contents`: `edits` of their tables, damaged, or any bytes that begin so."""
    damage = st.sampled_from(contents).flatmap(damaged)
    rubbish = st.binary(max_size=200).map(lambda rest: b"PAR1" + rest)
    return st.one_of(edits, edits, edits, damage, rubbish)
