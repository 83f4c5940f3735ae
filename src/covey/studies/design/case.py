"""A case of a study's grid, an initial state, and the game that both make."""

from __future__ import annotations

from typing import Any, NamedTuple

from covey.model import Objective, PursuerDisk, Team
from covey.simulation import PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy
from covey.studies.design.as_visible import AsVisible

AnyTeam = TeamStrategy | TeamPolicy
AnyPursuer = PursuerStrategy | PursuerPolicy | AsVisible


class Case(NamedTuple):
    """One combination of the grid: all of a game but its start."""

    team_size: int
    speed: float
    turn_rate: float | None  # None: `turn_radius` tells
    turn_radius: float | None
    pursuer_speed: float
    disk_radius: float
    capture_radius: float
    update_time: float
    sensing: str
    objective: Objective
    evaders: AnyTeam
    pursuer: AnyPursuer


GRID = Case._fields
UNITS_OF = {
    "speed": "speed",
    "turn_rate": "turn_rate",
    "turn_radius": "length",
    "pursuer_speed": "speed",
    "disk_radius": "length",
    "capture_radius": "length",
    "update_time": "time",
}
"""Of which of the `Units` the fields of the grid with units are."""


class InitialState(NamedTuple):
    """Where a team starts, and the seed of the searches for its plans."""

    positions: Any  # (N, 2)
    headings: Any  # (N,)
    seed: int


def game_of(case: Case, start: InitialState) -> tuple[Team, PursuerDisk]:
    """Return the state of a game at time 0."""
    return (
        Team(
            start.positions,
            start.headings,
            case.speed,
            case.turn_rate,
            turn_radii=case.turn_radius,
        ),
        PursuerDisk((0.0, 0.0), case.disk_radius, case.pursuer_speed, case.capture_radius),
    )
