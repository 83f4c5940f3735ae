"""A game as JSON for the page: a header (the key "cast"), and a frame ("picture") for each row."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from covey.simulation import Game
from covey.simulation.expected_captures import expected_at

MAX_FRAMES = 1500
"""Of a replay: with more frames, a page loads more slowly and looks no smoother."""

_KEEPS_GUARANTEE = {"open-loop", "iterative-open-loop"}
"""Teams that always survive at least as long as their first plan guarantees."""

Json = dict[str, Any]


def header(game: Game) -> Json:
    """Return what is constant during a game."""
    names = {side: str(each.get("name", "")) for side, each in game.strategies.items()}
    return {
        "evaders": len(game.team),
        "speeds": game.team.speeds.tolist(),
        # None: unlimited.
        "turn_rates": [rate if math.isfinite(rate) else None for rate in game.team.turn_rates],
        "pursuer_speed": game.disk.speed,
        "capture_radius": game.disk.capture_radius,
        "sensing": game.sensing,
        "units": {"length": game.team.units.length, "time": game.team.units.time},
        "guarantee": game.guarantee,
        "sure": names.get("evaders") in _KEEPS_GUARANTEE,
        "strategies": names,
    }


def frame(game: Game, row: int) -> Json:
    """Return one row: the state, the plan that is flown from then on, and its expected captures."""
    critical = game.critical_sequences[row]
    sequence = critical[critical >= 0]
    captured = len(game.team) - len(sequence)
    return {
        "time": float(game.times[row]),
        "evaders": np.column_stack(
            [game.evader_positions[row], game.evader_headings[row], game.evader_turns[row]]
        ).tolist(),
        "pursuer": game.pursuer_positions[row].tolist(),
        "disk": [*game.disk_centers[row].tolist(), float(game.disk_radii[row])],
        "guarantee": float(game.guarantees[row]),
        "sequence": sequence.tolist(),
        "expected": expected_at(game, row).tolist(),
        "captured": [
            [int(i), float(time)]
            for i, time in zip(
                game.capture_sequence[:captured], game.capture_times[:captured], strict=True
            )
        ],
    }


def film(game: Game, which: str) -> str:
    """Return the message with which the page replays a game; a nan is a ValueError."""
    return json.dumps({"type": "film", "game": which, **replay(game)}, allow_nan=False)


def replay(game: Game) -> Json:
    """Return the whole game: at most `MAX_FRAMES` of its rows, and those around captures."""
    rows = np.linspace(0, len(game.times) - 1, min(MAX_FRAMES, len(game.times)), dtype=int)
    captures = np.searchsorted(game.times, game.capture_times, side="right") - 1
    before = np.searchsorted(game.times, game.capture_times, side="left") - 1
    rows = np.unique(np.concatenate([rows, np.maximum(before, 0), captures]))
    time = game.survival_time
    return {
        "cast": header(game),
        "pictures": [frame(game, row) for row in rows.tolist()],
        "survival_time": time if math.isfinite(time) else None,
    }
