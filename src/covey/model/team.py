"""The team: evaders with limited turning rates (Dubins vehicles)."""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.model.validation import Floats, InputError, Ints, frozen_array, frozen_rates, read_only

LARGEST_HEADING = 1e9 + 1e6
"""Radians. Double precision tells headings of this size apart to 1e-7.

An evader that begins with 1e9 comes to no more than this by turning in 200 000 updates.
"""


@dataclass(frozen=True, eq=False)
class Team:
    """A team of N evaders, each flying at constant speed with a limited turning rate.

    Parameters
    ----------
    positions
        (N, 2), lengths. N >= 1.
    headings
        (N,), radians counter-clockwise from +x, up to 1e9 in size.
    speeds
        One number or (N,), lengths per time, >= 0. Default 0.25 (section V of the paper).
    turn_rates
        One number or (N,), radians per time, >= 0. `inf` is simple motion: the evader turns in no
        time. Default π/2 (section V of the paper).

    Attributes
    ----------
    positions, headings, speeds, turn_rates : numpy.ndarray
        As above, broadcast to one row an evader, read-only.

    Raises
    ------
    InputError
        If a shape is wrong, a number is not finite, or a speed or turn rate is negative.

    Examples
    --------
    >>> import math
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4]], headings=[0.0, math.pi], speeds=[0.25, 0.2])
    >>> len(team)
    2
    >>> team.turn_rates.round(4).tolist()
    [1.5708, 1.5708]
    """

    positions: Floats
    headings: Floats
    speeds: Floats
    turn_rates: Floats

    def __init__(
        self,
        positions: npt.ArrayLike,
        headings: npt.ArrayLike,
        speeds: npt.ArrayLike = 0.25,
        turn_rates: npt.ArrayLike = math.pi / 2,
    ) -> None:
        positions = frozen_array("positions", positions, (None, 2))
        count = len(positions)
        if count == 0:
            raise InputError("positions: expected at least one evader, got none")
        headings = frozen_array("headings", headings, (None,), LARGEST_HEADING)
        if len(headings) != count:
            raise InputError(
                f"headings: expected one for each of {count} evaders, got shape {headings.shape}"
            )
        for name, value in (
            ("positions", positions),
            ("headings", headings),
            ("speeds", frozen_rates("speeds", speeds, count, infinite=False)),
            ("turn_rates", frozen_rates("turn_rates", turn_rates, count, infinite=True)),
        ):
            object.__setattr__(self, name, value)

    def __len__(self) -> int:
        """Number of evaders."""
        return len(self.headings)

    def take(self, rows: Ints) -> Team:
        """Return the team of the evaders `rows` (M,) alone, in that order."""
        return Team(
            self.positions[rows], self.headings[rows], self.speeds[rows], self.turn_rates[rows]
        )

    def moved(self, by: Floats) -> Team:
        """Return the team, moved `by` (2,)."""
        moved = copy(self)
        object.__setattr__(moved, "positions", read_only(self.positions + by))
        return moved

    def as_rows(self) -> Floats:
        """Return (N, 5) rows (x, y, heading, speed, turn rate), as the kernels read them."""
        rows = np.empty((len(self), 5))
        rows[:, :2] = self.positions
        rows[:, 2], rows[:, 3], rows[:, 4] = self.headings, self.speeds, self.turn_rates
        return rows
