"""The captures to expect, along the sequence that captures a plan earliest."""

from __future__ import annotations

import numpy as np

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats, Ints
from covey.planning import capture_times
from covey.simulation.record import Game


def expected_captures(team: Team, disk: PursuerDisk, turns: Floats, sequence: Ints) -> Floats:
    """Return the capture times (M,), from now, of the M evaders in `sequence`.

    `turns` (N,) is the plan of the whole team; the evaders that `sequence` leaves out are captured.
    """
    if not len(sequence):
        return np.empty(0)
    order = np.arange(len(sequence))
    return capture_times(team.take(sequence), disk, turns[sequence], order)


def expected_at(game: Game, row: int) -> Floats:
    """Return the capture times (M,), from the start of the game, to expect at a row of a record."""
    positions, headings = game.evader_positions[row], game.evader_headings[row]
    team = Team(positions, headings, game.team.speeds, game.team.turn_rates)
    disk = PursuerDisk(
        game.disk_centers[row], game.disk_radii[row], game.disk.speed, game.disk.capture_radius
    )
    critical = game.critical_sequences[row]
    sequence = critical[critical >= 0]
    times: Floats = game.times[row] + expected_captures(
        team, disk, game.evader_turns[row], sequence
    )
    return times
