"""The captures that a plan must expect, in the order by which the team is captured earliest."""

from __future__ import annotations

import numpy as np

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats, Ints
from covey.planning import capture_times
from covey.simulation.record import Game


def expected_captures(team: Team, disk: PursuerDisk, turns: Floats, sequence: Ints) -> Floats:
    """Return the capture times (M,), from now, of the M evaders in `sequence`.

    The sequence may leave out evaders of the team, such as captured evaders.
    """
    if not len(sequence):
        return np.empty(0)
    return capture_times(team.take(sequence), disk, turns[sequence], np.arange(len(sequence)))


def expected_in_game(game: Game, row: int) -> Floats:
    """Return the times, from the start of the game, of the captures to expect at a row."""
    critical = game.critical_sequences[row]
    team = Team(
        game.evader_positions[row],
        game.evader_headings[row],
        game.team.speeds,
        game.team.turn_rates,
    )
    disk = PursuerDisk(
        game.disk_centers[row], game.disk_radii[row], game.disk.speed, game.disk.capture_radius
    )
    sequence = critical[critical >= 0]
    return expected_captures(team, disk, game.evader_turns[row], sequence) + float(game.times[row])
