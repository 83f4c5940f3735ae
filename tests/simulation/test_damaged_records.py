"""A record whose numbers were changed, and its checksum with them, is refused or can be drawn."""

from __future__ import annotations

import dataclasses
import json
import math
from contextlib import suppress
from io import BytesIO

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from covey import views
from covey.simulation.consistency import require_consistent
from covey.simulation.storage import _checksum, read_game, write_game
from players.test_any_game import PURSUERS, TEAMS
from random_games import extent, games, random_game
from soak import custom_pursuers

OBJECTIVES = [covey.LastCapture(), covey.TotalSurvival(), covey.ExpectedSurvival()]
NASTY = [
    *(None, True, -1, 0, 1, 99, 2**70, 0.5, -0.5, 1e-300, 1e308, math.nan, math.inf, -math.inf),
    *("", "x", [], {}, [0.0], [[1]], {"float": "nan"}, {"name": "x"}),
]
NUMBERS = [value for value in NASTY if isinstance(value, int | float)]


def written(game):
    buffer = BytesIO()
    write_game(game, buffer)
    return buffer.getvalue()


def played(seed, count, sensing="hidden", time_limit=None, pursuer=None, **disk):
    team, disk = random_game(np.random.default_rng(seed), count, mixed=True, **disk)
    return covey.simulate(
        team,
        disk,
        pursuer=pursuer or covey.CommittedPursuer(),
        sensing=sensing,
        update_time=0.2,
        time_limit=time_limit,
    )


RECORDS = [
    played(1, 3),
    played(2, 2, "visible", radius=0.2),
    played(3, 3, "visible", capture_radius=0.05),
    played(4, 2, radius=0.2, capture_radius=0.05),
    played(5, 3, time_limit=0.6),
    played(6, 1, "visible", pursuer=covey.FlyingPursuer(offset=(0.6, 0.8)), capture_radius=0.1),
]


@pytest.mark.parametrize("evaders", TEAMS, ids=lambda team: type(team).__name__)
@given(
    game=games(most=4),
    pursuer=st.sampled_from(PURSUERS),
    sensing=st.sampled_from(["hidden", "visible"]),
    objective=st.sampled_from(OBJECTIVES),
    update=st.sampled_from([0.1, 3.0]),
)
@settings(max_examples=25)
def test_every_legal_record_is_consistent(evaders, game, pursuer, sensing, objective, update):
    team, disk, _ = game
    step = update * (extent(team, disk) or 1.0) / disk.speed
    record = covey.simulate(
        team,
        disk,
        evaders=evaders,
        pursuer=pursuer,
        sensing=sensing,
        objective=objective,
        update_time=step,
        time_limit=4.0 * step,
    )
    require_consistent(record)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("pursuer", ["redrawing", "farthest_first", "roaming", "waiting"])
def test_records_of_ones_own_pursuers_are_consistent(sensing, pursuer):
    if (sensing, pursuer) == ("hidden", "roaming"):
        return  # a disk can't be steered
    strategy = getattr(custom_pursuers, pursuer)(0)
    for reach in (0.0, 0.05):
        record = played(7, 4, sensing, 9.0, strategy, radius=0.1, capture_radius=reach)
        require_consistent(record)


def test_a_game_in_a_frame_far_away_is_consistent():
    team, disk = random_game(np.random.default_rng(8), 4)
    far = covey.Team(team.positions + 1e4, team.headings + 100.0, team.speeds, team.turn_rates)
    there = covey.PursuerDisk(disk.center + 1e4, 0.1, disk.speed, 0.01)
    for sensing in ("hidden", "visible"):
        require_consistent(covey.simulate(far, there, sensing=sensing))


VISIBLE = RECORDS[1]
TURNED = covey.Team(
    VISIBLE.team.positions,
    VISIBLE.team.headings + 0.1,
    VISIBLE.team.speeds,
    VISIBLE.team.turn_rates,
)
MOVED = covey.Team(
    VISIBLE.team.positions + 0.1,
    VISIBLE.team.headings,
    VISIBLE.team.speeds,
    VISIBLE.team.turn_rates,
)


def changed_row(field, index, value):
    """The second record with one number changed."""
    array = getattr(VISIBLE, field).copy()
    array[index] = value
    return {field: array}


def leaping():
    """The second record, in which the pursuer is too far away for one row."""
    position = VISIBLE.pursuer_positions[2] + [0.5, 0.0]
    fields = ("pursuer_positions", "disk_centers")
    return {name: changed_row(name, 2, position)[name] for name in fields}


def beside():
    """The second record, in which the pursuer is beside whom it captures last."""
    position = VISIBLE.pursuer_positions[-1] + [1e-3, 0.0]
    fields = ("pursuer_positions", "disk_centers")
    return {name: changed_row(name, -1, position)[name] for name in fields}


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (changed_row("critical_sequences", (0, 0), 99), "critical_sequences[0]: expected evaders"),
        (changed_row("pursuer_sequences", (1, 0), 2), "pursuer_sequences[1]: expected evaders"),
        (changed_row("evader_positions", (2, 0, 0), 1e308), "evader_positions: expected finite"),
        (changed_row("evader_positions", (2, 0, 0), 0.3), "evader_positions[2]: expected the"),
        (changed_row("evader_headings", (2, 0), 9.0), "evader_headings[2]: expected the flight"),
        (changed_row("evader_turns", (1, 0), 4.0), "evader_turns[1]: expected radians"),
        (changed_row("times", 1, 0.0), "times[1]: expected the next time at most 0.2 later"),
        (changed_row("times", 0, -0.1), "times[0]: expected 0"),
        (changed_row("pursuer_positions", (1, 0), 0.3), "disk_centers[1]: expected the disk"),
        (changed_row("disk_radii", 1, 0.1), "disk_radii[1]: expected the disk"),
        (changed_row("disk_radii", 0, 0.1), "disk_centers[0]: expected the disk of the game"),
        (changed_row("guarantees", 1, math.inf), "guarantees[1]: expected a finite number"),
        (changed_row("capture_times", 0, 0.1), "capture_times[0]: expected the time of the row"),
        (changed_row("capture_sequence", 0, 7), "capture_sequence[0]: expected evaders 0 to 1"),
        (changed_row("capture_sequence", 0, 1), "capture_sequence: expected each evader once"),
        ({"guarantee": 0.5}, "guarantee: expected "),
        ({"survival_time": 9.0}, "survival_time: expected "),
        ({"value": 9.0}, "value: expected "),
        ({"status": covey.GameStatus.TIME_LIMIT}, "status: expected who was captured"),
        ({"update_time": 0.0}, "update_time: expected a finite number > 0, got 0.0"),
        ({"update_time": 0.1}, "times[0]: expected the next time at most 0.1 later"),
        ({"seed": -1}, "seed: expected a whole number >= 0, got -1"),
        ({"sensing": "hidden"}, "disk_centers[1]: expected the disk"),
        ({"sensing": "blind"}, "sensing: expected one of hidden, visible, got 'blind'"),
        ({"strategies": {"evaders": {}}}, "strategies: expected both sides"),
        ({"strategies": {"evaders": {}, "pursuer": 3}}, "pursuer: expected its name"),
        ({"objective": {}}, "objective: expected a name"),
        ({"team": TURNED}, "team[0]: expected the positions and headings of the first row"),
        ({"team": MOVED}, "team[0]: expected the positions and headings of the first row"),
        ({"planned_value": math.inf}, "planned_value: expected a finite number"),
        ({"critical_sequences": 1.0 * VISIBLE.critical_sequences}, "critical_sequences: expected"),
        (changed_row("critical_sequences", 0, 0), "critical_sequences[0]: expected each living"),
        (changed_row("critical_sequences", 0, [-1, 0]), "critical_sequences: expected one evader"),
        (changed_row("pursuer_sequences", 0, [0, 0]), "pursuer_sequences[0]: expected each living"),
        (changed_row("pursuer_sequences", -1, [0, -1]), "pursuer_sequences[12]: expected each"),
        (changed_row("times", 3, 0.19), "times[2]: expected a time that is not after the next"),
        (changed_row("assurances", 3, 9.0), "assurances[4]: expected no later time than the row"),
        (changed_row("assurances", ..., 0.1), "assurances[1]: expected a time by which everybody"),
        (changed_row("assurances", 0, math.nan), "assurances[0]: expected a number >= 0, or inf"),
        (changed_row("guarantees", -1, 0.1), "guarantees[-1]: expected 0"),
        (changed_row("evader_turns", -1, 0.1), "evader_turns[12]: expected 0 for captured"),
        ({"capture_sequence": np.arange(3)}, "capture_times: expected an array of shape (3,)"),
        ({"objective": {"name": "mine"}, "value": math.inf}, "value: expected a finite number"),
        (leaping(), "disk_centers[2]: expected a centre that the pursuer can have reached"),
        (beside(), "pursuer_positions[12]: expected a point of the disk, within reach"),
        ({"disk": covey.PursuerDisk((0, 0), 0.2, 0.5)}, "speeds: expected every evader to be"),
    ],
)
def test_what_contradicts_itself_is_told(changes, message):
    content = written(dataclasses.replace(VISIBLE, **changes))
    with pytest.raises(covey.InputError) as caught:
        read_game(content, "a.parquet")
    assert str(caught.value).startswith(f"a.parquet: it contradicts itself: {message}")


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


def test_more_evaders_than_can_play_are_refused():
    """Before their table is looked at: the checks take memory by the square of the team."""
    row = {
        name: np.repeat(getattr(RECORDS[5], name)[:1], 21, axis=1)
        for name in ("evader_positions", "evader_headings", "evader_turns", "pursuer_sequences")
    }
    crowd = dataclasses.replace(
        RECORDS[5],
        **row,
        **{
            name: getattr(RECORDS[5], name)[:1]
            for name in (
                "times",
                "guarantees",
                "assurances",
                "pursuer_positions",
                "disk_centers",
                "disk_radii",
            )
        },
        team=RECORDS[5].team.take(np.zeros(21, np.int64)),
        critical_sequences=np.arange(21)[None],
    )
    with pytest.raises(covey.InputError, match="team: expected at most 20 evaders, got 21"):
        read_game(written(crowd), "a.parquet")


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
