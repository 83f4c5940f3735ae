"""A game between any two strategies, in Python, by the rules of compiled games."""

from __future__ import annotations

from covey.model import PursuerDisk, Team
from covey.simulation.match import Match
from covey.simulation.record import Game
from covey.simulation.settings import Settings
from covey.simulation.strategy import PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy


def play(
    team: Team,
    disk: PursuerDisk,
    evaders: TeamStrategy | TeamPolicy,
    pursuer: PursuerStrategy | PursuerPolicy,
    settings: Settings,
) -> Game:
    """Play a game, asking both strategies at every update and after every capture.

    Raises
    ------
    InputError
        If a strategy decides what the rules forbid: turns that aren't n numbers in [-π, π], a
        sequence with an evader that isn't alive, a velocity above the pursuer's speed, any velocity
        for a pursuer that is a disk only, a position outside the disk.
    """
    return play_out(Match(team, disk, evaders, pursuer, settings)).record()


def play_out(match: Match) -> Match:
    """Play a game to its end, and return it."""
    while not match.over:
        match.step()
    return match
