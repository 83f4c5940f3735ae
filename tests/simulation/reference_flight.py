"""Flight by the book: eq. (2) and (5) of the paper, written without a look at the kernels."""

from __future__ import annotations

import numpy as np


def fly(position, heading, speed, turn_rate, turn, times):
    """Places (T, 2) and headings (T,) of one evader at `times` (T,).

    It turns by `turn` at its full rate, on a circle about a fixed centre, and then flies straight.
    """
    times = np.asarray(times, dtype=float)
    places = np.tile(np.asarray(position, dtype=float), (len(times), 1))
    turning_time = abs(turn) / turn_rate if turn_rate > 0.0 else 0.0
    headings = np.full_like(times, heading + turn if turn_rate > 0.0 else heading)
    if turning_time > 0.0:
        side = np.sign(turn)
        turning = times < turning_time
        headings[turning] = heading + side * turn_rate * times[turning]
        radius = side * speed / turn_rate
        places[:, 0] += radius * (np.sin(headings) - np.sin(heading))
        places[:, 1] -= radius * (np.cos(headings) - np.cos(heading))
    straight = speed * np.maximum(times - turning_time, 0.0)
    places += straight[:, None] * np.column_stack([np.cos(headings), np.sin(headings)])
    return places, headings


def alive(game, row):
    """Numbers of those who are alive in a row of the record."""
    critical = game.critical_sequences[row]
    return sorted(critical[critical >= 0].tolist())


def flown(game, row, times):
    """Places {i: (T, 2)} and headings {i: (T,)} of the living at `times` (T,) after a row."""
    places, headings = {}, {}
    for i in alive(game, row):
        places[i], headings[i] = fly(
            game.evader_positions[row, i],
            game.evader_headings[row, i],
            game.team.speeds[i],
            game.team.turn_rates[i],
            game.evader_turns[row, i],
            times,
        )
    return places, headings


def captures(game):
    """Who was captured, and in which row of the record."""
    for row in range(1, len(game.times)):
        for i in set(alive(game, row - 1)) - set(alive(game, row)):
            yield i, row
