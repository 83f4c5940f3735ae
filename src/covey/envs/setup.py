"""Which game an environment plays: its players, its rules, and its initial states."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels.play.rules import Rules, State
from covey.model import InputError, PursuerDisk, Team
from covey.model.angles import away_from, unit_vectors
from covey.model.validation import Floats, choice, frozen_array, number, whole_number
from covey.planning.border import check_game
from covey.players import IterativeOpenLoop
from covey.simulation import Settings
from covey.simulation.settings import first_state

HEADINGS = ("away", "random")

STARTS = 8
"""Starts of the search for what a game guarantees; 32 find 0.02 % more for N = 3, 0.5 % for 5."""

TEAM = IterativeOpenLoop(starts=STARTS, restarts=2)
"""The default opponent: within 0.2 % it survives as long as with all starts."""


class InitialState(NamedTuple):
    """Positions and headings of the evaders, and the pursuer's position, at time 0."""

    positions: Floats  # (N, 2)
    headings: Floats  # (N,)
    pursuer: Floats  # (2,)


@dataclass(frozen=True, eq=False)
class Setup:
    """The game that an environment plays. Lengths and times are in any consistent unit.

    Parameters
    ----------
    team_size
        Evaders, 1 to 50.
    speed, turn_rate
        Of every evader, or one for each. A turn rate of inf turns at once.
    pursuer_speed
        Larger than every evader's.
    capture_radius
        ρ > 0: actions would hardly ever lead a pursuer with ρ = 0 to a capture.
    disk_radius
        The pursuer starts anywhere in a disk of this radius around the origin.
    sensing
        "visible", or "hidden": the evaders see only the disk that contains the pursuer.
    update_time
        Δt > 0, the time of a step that brings no capture.
    time_limit
        A game is truncated at this time.
    side
        Evaders start uniformly in a square of this side around the origin.
    headings
        At the start: "away" from the origin, or "random".

    Raises
    ------
    InputError
        If a field is outside of its range.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> setup = pursuit_v0.Setup(team_size=4, speed=0.3, capture_radius=0.05)
    >>> setup.team_size, setup.sensing
    (4, 'visible')
    """

    team_size: int = 3
    speed: npt.ArrayLike = 0.25
    turn_rate: npt.ArrayLike = math.pi / 2
    pursuer_speed: float = 1.0
    capture_radius: float = 0.02
    disk_radius: float = 0.0
    sensing: str = "visible"
    update_time: float = 0.05
    time_limit: float = 20.0
    side: float = 1.0
    headings: str = "away"

    def __post_init__(self) -> None:
        """Check every field."""
        whole_number("team_size", self.team_size, low=1)
        number("capture_radius", self.capture_radius, low=0.0, strictly=True)
        number("time_limit", self.time_limit, low=0.0, strictly=True)
        number("side", self.side, low=0.0, strictly=True)
        choice("headings", self.headings, HEADINGS)
        Settings(self.sensing, self.update_time, 0, self.time_limit)
        check_game(self._anywhere, self.disk_around(np.zeros(2), self.disk_radius))

    @cached_property
    def rules(self) -> Rules:
        """The rules for the kernels; the pursuer has a position, also if it is hidden."""
        settings = Settings(self.sensing, self.update_time, 0, self.time_limit)
        return settings.rules(self.disk_around(np.zeros(2), 0.0), has_position=True)

    @cached_property
    def largest_turns(self) -> Floats:
        """(N,) largest turn of each evader in a step, radians: min(ω Δt, π)."""
        return np.minimum(self._anywhere.turn_rates * self.update_time, math.pi)

    @cached_property
    def fastest(self) -> float:
        """Speed of the fastest evader."""
        return float(self._anywhere.speeds.max())

    def team(self, initial: InitialState) -> Team:
        """Return the team at time 0."""
        return Team(initial.positions, initial.headings, self.speed, self.turn_rate)

    def first_state(self, initial: InitialState) -> State:
        """Return the kernels' state at time 0, with no turns announced."""
        return first_state(self.team(initial), self.known_at_start(initial), initial.pursuer)

    def disk_around(self, center: Floats, radius: float) -> PursuerDisk:
        """Return a disk of this pursuer."""
        return PursuerDisk(center, radius, self.pursuer_speed, self.capture_radius)

    def known_at_start(self, initial: InitialState) -> PursuerDisk:
        """Return the disk that the team knows of at time 0."""
        if self.rules.hidden:
            return self.disk_around(np.zeros(2), self.disk_radius)
        return self.disk_around(initial.pursuer, 0.0)

    def draw(
        self, generator: np.random.Generator, options: Mapping[str, Any] | None
    ) -> InitialState:
        """Draw an initial state; `options` may set its "positions" and "headings".

        Raises
        ------
        InputError
            If a position given is outside of the square, or headings come without positions.
        """
        half, count = 0.5 * self.side, self.team_size
        positions = generator.uniform(-half, half, (count, 2))
        headings = generator.uniform(-math.pi, math.pi, count)
        # The root makes rings of equal area equally likely.
        distance = self.disk_radius * math.sqrt(generator.uniform())
        bearing = generator.uniform(-math.pi, math.pi)
        pursuer = distance * unit_vectors(bearing)
        given = options or {}
        if "positions" in given:
            positions = frozen_array("positions", given["positions"], (count, 2))
            if np.abs(positions).max() > half:
                raise InputError(
                    f"positions: expected evaders in a square of side {self.side:g} around the "
                    f"origin, got {positions.tolist()}; give the environment a larger `side`"
                )
        if self.headings == "away":
            headings = away_from((0.0, 0.0), positions)
        if "headings" in given:
            if "positions" not in given:
                raise InputError("headings: expected positions with them, got headings alone")
            headings = frozen_array("headings", given["headings"], (count,))
        return InitialState(positions, headings, pursuer)

    @cached_property
    def _anywhere(self) -> Team:
        """A team at the origin, to check and broadcast speeds and turn rates."""
        count = self.team_size
        return Team(np.zeros((count, 2)), np.zeros(count), self.speed, self.turn_rate)
