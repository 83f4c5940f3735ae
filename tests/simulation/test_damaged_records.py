"""A record whose numbers were changed, and its checksum with them, is refused or can be drawn."""

from __future__ import annotations

import dataclasses
import json
import math
from contextlib import suppress

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from covey import views
from covey.simulation.storage import _checksum, read_game
from simulation.played_records import RECORDS, written

NASTY = [
    *(None, True, -1, 0, 1, 99, 2**70, 0.5, -0.5, 1e-300, 1e308, math.nan, math.inf, -math.inf),
    *("", "x", [], {}, [0.0], [[1]], {"float": "nan"}, {"name": "x"}),
]


NUMBERS = [value for value in NASTY if isinstance(value, int | float)]


@dataclasses.dataclass
class Damaged:
    """A record in a file, what was changed there, and the checksum with it."""

    header: dict
    table: pa.Table = dataclasses.field(repr=False)
    changes: list = dataclasses.field(default_factory=list)

    def change_header(self, draw):
        *path, key = draw(st.sampled_from(list(leaves(self.header))))
        parent = self.header
        for step in path:
            parent = parent[step]
        value = draw(st.sampled_from(["gone", *NASTY]))
        if value == "gone":
            del parent[key]
        else:
            parent[key] = value
        self.changes.append((*path, key, value))

    def change_number(self, draw):
        at, column = self.column(draw)
        value = draw(st.sampled_from(NUMBERS) | st.floats(-1.0, 1.0))
        if len(column) and column.dtype.kind in "if":
            row = draw(st.integers(0, len(column) - 1))
            with suppress(OverflowError, ValueError):  # what the column can't hold
                column[row] = value
            self.replace(at, column, (row, value))

    def change_type(self, draw):
        at, column = self.column(draw)
        kind = draw(st.sampled_from([str, np.float32]))
        self.replace(at, column.astype(kind), kind)

    def drop_rows(self, draw):
        rows = draw(st.tuples(st.integers(0, 2), st.integers(0, 9)))
        self.table = self.table.slice(*rows)
        self.changes.append(rows)

    def column(self, draw):
        at = draw(st.integers(0, self.table.num_columns - 1))
        return at, self.table.column(at).to_numpy().copy()

    def replace(self, at, column, change):
        name = self.table.column_names[at]
        self.table = self.table.set_column(at, name, pa.array(column))
        self.changes.append((name, change))

    def content(self):
        note = json.dumps(self.header).encode()
        notes = {b"covey": note, b"covey_crc32": _checksum(note, self.table)}
        sink = pa.BufferOutputStream()
        pq.write_table(self.table.replace_schema_metadata(notes), sink)
        return sink.getvalue().to_pybytes()


def leaves(tree, path=()):
    """The paths of everything in nested tables and lists."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, value in items:
        yield (*path, key)
        if isinstance(value, dict | list) and value:
            yield from leaves(value, (*path, key))


@st.composite
def damaged(draw):
    """A record of which one to three things were changed."""
    table = pq.read_table(pa.BufferReader(written(draw(st.sampled_from(RECORDS)))))
    record = Damaged(json.loads(table.schema.metadata[b"covey"]), table)
    changes = [record.change_number, record.change_header, record.change_type, record.drop_rows]
    for _ in range(draw(st.integers(1, 3))):
        draw(st.sampled_from(changes))(draw)
    return record


@given(record=damaged())
@settings(max_examples=60)
def test_what_was_changed_is_refused_or_can_be_drawn(record):
    game = None
    with suppress(covey.InputError):
        game = read_game(record.content(), "a.parquet")
    if game is not None:
        views.draw_snapshots(game).canvas.draw()
        views.draw_game(game).canvas.draw()
