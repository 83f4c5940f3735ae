"""A record that contradicts itself is refused, with what was expected."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import covey
from covey.simulation.storage import read_game
from simulation.played_records import RECORDS, written

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


def test_more_evaders_than_can_play_are_refused():
    """Before their table is looked at: the checks take memory by the square of the team."""
    row = {
        name: np.repeat(getattr(RECORDS[5], name)[:1], 51, axis=1)
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
        team=RECORDS[5].team.take(np.zeros(51, np.int64)),
        critical_sequences=np.arange(51)[None],
    )
    with pytest.raises(covey.InputError, match="team: expected at most 50 evaders, got 51"):
        read_game(written(crowd), "a.parquet")
