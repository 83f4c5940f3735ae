"""A game as the page draws it: one picture a row of the record, in what JSON can say."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from covey.simulation import Game
from covey.simulation.expected_captures import expected_at

MOST_PICTURES = 1500
"""Of a film: with more, a page would be slow to load it and no smoother."""

_KEEPS_GUARANTEE = {"open-loop", "iterative-open-loop"}
"""Teams that never fall short of what their first plan is worth."""

Json = dict[str, Any]


def cast(game: Game) -> Json:
    """Return what stays the same during a game."""
    names = {side: str(each.get("name", "")) for side, each in game.strategies.items()}
    return {
        "evaders": len(game.team),
        "speeds": game.team.speeds.tolist(),
        # None: it turns at once.
        "turn_rates": [rate if math.isfinite(rate) else None for rate in game.team.turn_rates],
        "pursuer_speed": game.disk.speed,
        "capture_radius": game.disk.capture_radius,
        "sensing": game.sensing,
        "guarantee": game.guarantee,
        "sure": names.get("evaders") in _KEEPS_GUARANTEE,
        "strategies": names,
    }


def picture(game: Game, row: int) -> Json:
    """Return one row: the state, the plan that is flown from there on, and what it expects."""
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


def film(game: Game) -> Json:
    """Return the whole game, with at most `MOST_PICTURES` of its rows and those of the captures."""
    rows = np.linspace(0, len(game.times) - 1, min(MOST_PICTURES, len(game.times)), dtype=int)
    captures = np.searchsorted(game.times, game.capture_times, side="right") - 1
    before = np.searchsorted(game.times, game.capture_times, side="left") - 1
    rows = np.unique(np.concatenate([rows, np.maximum(before, 0), captures]))
    time = game.survival_time
    return {
        "cast": cast(game),
        "pictures": [picture(game, row) for row in rows.tolist()],
        "survival_time": time if math.isfinite(time) else None,
    }
