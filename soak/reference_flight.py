"""Flight by the book: eq. (2) and (5) of the paper, written without a look at the kernels.

Shapes broadcast: one evader at many times, or all evaders of a game in all rows of its record.
"""

from __future__ import annotations

import math

import numpy as np


def fly(position, heading, speed, turn_rate, turn, times):
    """Places (..., 2) and headings (...) at `times` (...) from now, an evader's or many evaders'.

    An evader turns by `turn` at its full rate, on a circle, and then flies straight. The chord of
    an arc of length s that turns by β is s sin(β/2) / (β/2) long, and β/2 off the heading.
    """
    position, times = np.asarray(position, dtype=float), np.asarray(times, dtype=float)
    with np.errstate(divide="ignore", invalid="ignore"):
        turning_time = np.where(np.equal(turn_rate, 0.0), math.inf, np.abs(turn) / turn_rate)
        turned = np.where(times < turning_time, turn_rate * times * np.sign(turn), turn)
    arc = speed * np.minimum(times, turning_time)
    chord, middle = arc * np.sinc(turned / (2.0 * math.pi)), heading + turned / 2.0
    goal, straight = heading + turned, speed * np.maximum(times - turning_time, 0.0)
    x = chord * np.cos(middle) + straight * np.cos(goal)
    y = chord * np.sin(middle) + straight * np.sin(goal)
    return position + np.stack([x, y], axis=-1), goal


def living(game):
    """(T, N) who is alive in each row of the record."""
    numbers = np.arange(len(game.team))
    return (game.critical_sequences[:, :, np.newaxis] == numbers).any(axis=1)


def flown(game, times):
    """Places (K, T - 1, N, 2) and headings (K, T - 1, N) at `times` (K, T - 1) after each row.

    Of the captured too, as if they still flew: `living` tells whom to look at.
    """
    team = game.team
    return fly(
        game.evader_positions[:-1],
        game.evader_headings[:-1],
        team.speeds,
        team.turn_rates,
        game.evader_turns[:-1],
        np.asarray(times)[..., np.newaxis],
    )


def captures(game):
    """Who was captured, and in which row of the record."""
    alive = living(game)
    rows, evaders = np.nonzero(alive[:-1] & ~alive[1:])
    return [(int(i), int(row) + 1) for row, i in zip(rows, evaders, strict=True)]
