"""Records of games: what loads can be sent to the page, saved again and drawn."""

from __future__ import annotations

import json
from contextlib import suppress
from io import BytesIO

import matplotlib.pyplot as plt
import numpy as np
from hypothesis import strategies as st

import covey
from covey import views
from covey.simulation.storage import _CHECKSUM_KEY, _KEY, _checksum, read_game, write_game
from covey.web.game.upload import read_upload
from fuzz.oracle import refusal, require, require_game
from fuzz.parquet import edited_table, encoded, parquet_cases
from fuzz.target import Target, corpus


def check(content):
    """Read a record; draw it, and send it to the page."""
    try:
        game = read_game(content, "record")
    except covey.InputError as error:
        return refusal(error)
    require_game(game)
    json.dumps(read_upload(content), allow_nan=False)
    require(_written(read_game(_written(game), "again")) == _written(game), "saved otherwise")
    for draw in (views.draw_game, views.draw_snapshots):
        draw(game).canvas.draw()
    plt.close("all")
    return "drawn"


def _written(game):
    buffer = BytesIO()
    write_game(game, buffer)
    return buffer.getvalue()


def _played(seed, count, **settings):
    generator = np.random.default_rng(seed)
    team = covey.Team(
        generator.uniform(-0.5, 0.5, (count, 2)),
        generator.uniform(-3.0, 3.0, count),
        generator.choice([0.0, 0.25, 0.5], count),
        generator.choice([0.0, 1.0, np.inf], count),
    )
    disk = covey.PursuerDisk(radius=settings.pop("radius", 0.0), capture_radius=0.05)
    return covey.simulate(team, disk, update_time=0.2, **settings)


def _resealed(table):
    """Give an edited record the checksum of what it says now."""
    notes = dict(table.schema.metadata)
    with suppress(KeyError):  # two columns have the same name
        notes[_CHECKSUM_KEY] = _checksum(notes[_KEY], table)
    return encoded(table.replace_schema_metadata(notes))


RECORDS = [
    _written(_played(1, 3)),
    _written(_played(2, 2, sensing="visible", radius=0.2)),
    _written(_played(3, 3, time_limit=0.5, objective=covey.TotalSurvival())),
    _written(_played(4, 1, sensing="visible", pursuer=covey.FlyingPursuer())),
]
_EDITS = st.sampled_from(RECORDS).flatmap(lambda content: edited_table(content, _KEY))
_FILES = [*RECORDS, *(file.read_bytes() for file in corpus("records"))]
TARGET = Target("records", ".parquet", parquet_cases(_FILES, _EDITS.map(_resealed)), check)
