"""The team: evaders with limited turning rates (Dubins vehicles)."""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.model.display import angle_text, html_table, one_line, spread
from covey.model.units import Units, counted, titled, units_with, with_unit
from covey.model.validation import (
    LARGEST,
    Floats,
    InputError,
    Ints,
    frozen_array,
    frozen_rates,
    one_each,
    read_only,
    unit_name,
)
from covey.model.value import Value

DEFAULT_TURN_RATE = math.pi / 2

LARGEST_HEADING = 1e9 + 1e6
"""Radians. Double precision tells headings of this size apart to 1e-7.

An evader that begins with 1e9 comes to no more than this by turning in 200 000 updates.
"""


@dataclass(frozen=True, eq=False)
class Team(Value):
    """A team of N evaders, each flying at constant speed with a limited turning rate.

    Teams with equal numbers are equal, and have equal hashes.

    Parameters
    ----------
    positions
        (N, 2), lengths. N >= 1.
    headings
        One number or (N,), radians counter-clockwise from +x, up to 1e9 in size.
        `PursuerDisk.headings_away` has those that lead straight away from the pursuer.
    speeds
        One number or (N,), lengths per time, >= 0. Default 0.25 (section V of the paper).
    turn_rates
        One number or (N,), radians per time, >= 0. `inf` is simple motion: the evader turns in no
        time. Default π/2 (section V of the paper).
    turn_radii
        Instead of `turn_rates`: one number or (N,), lengths >= 0, of the tightest circle R at full
        speed. The turn rate is ω = v/R. 0 is simple motion; with `inf` the evader can't turn.
    unit
        The unit of all lengths of the game, "m" for example; all times are in seconds then. Tables
        and pictures name the units; nothing is converted. Default: no unit is named.

    Attributes
    ----------
    positions, headings, speeds, turn_rates : numpy.ndarray
        As above, broadcast to one row an evader, read-only.
    unit : str
        As above.

    Raises
    ------
    InputError
        If a shape is wrong, a number is not finite, a speed, turn rate or radius is negative,
        turn rates and radii are both given, or the unit isn't a short word.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4]], headings=[0.3, 2.0], speeds=[0.25, 0.2])
    >>> team.turn_rates.round(4).tolist()
    [1.5708, 1.5708]

    In metres and seconds, with a turning radius:

    >>> team = covey.Team([[900.0, 300.0]], [0.3], speeds=20.0, turn_radii=60.0, unit="m")
    >>> team.turn_rates.round(4).tolist()
    [0.3333]
    """

    positions: Floats
    headings: Floats
    speeds: Floats
    turn_rates: Floats
    unit: str

    def __init__(
        self,
        positions: npt.ArrayLike,
        headings: npt.ArrayLike,
        speeds: npt.ArrayLike = 0.25,
        turn_rates: npt.ArrayLike | None = None,
        *,
        turn_radii: npt.ArrayLike | None = None,
        unit: str = "",
    ) -> None:
        positions = frozen_array("positions", positions, (None, 2))
        count = len(positions)
        if count == 0:
            raise InputError("positions: expected at least one evader, got none")
        speeds = frozen_rates("speeds", speeds, count, infinite=False)
        for name, value in (
            ("positions", positions),
            ("headings", _headings(headings, count)),
            ("speeds", speeds),
            ("turn_rates", _turn_rates(speeds, turn_rates, turn_radii)),
            ("unit", unit_name("unit", unit)),
        ):
            object.__setattr__(self, name, value)

    def __len__(self) -> int:
        """Number of evaders."""
        return len(self.headings)

    def __repr__(self) -> str:
        """Return how many evaders there are, how fast, and how agile, in one line."""
        units = self.units
        return one_line(
            "Team",
            counted(len(self), "evader"),
            speeds=with_unit(spread(self.speeds), units.speed),
            turn_rates=with_unit(spread(self.turn_rates, angle_text), units.turn_rate),
        )

    def _repr_html_(self) -> str:
        length, _, speed, rate = self.units
        names = (
            *(titled(axis, length) for axis in ("x", "y")),
            titled("heading", "rad"),
            titled("speed", speed),
            titled("turn rate", rate),
        )
        *numbers, rates = self.as_rows().T.tolist()
        columns = dict(zip(names, [*numbers, map(angle_text, rates)], strict=True))
        return html_table(repr(self), {"evader": range(len(self)), **columns})

    @property
    def units(self) -> Units:
        """What tables and pictures write beside lengths, times, speeds and turn rates."""
        return units_with(self.unit)

    def take(self, rows: Ints) -> Team:
        """Return the team of the evaders `rows` (M,) alone, in that order."""
        return Team(
            self.positions[rows],
            self.headings[rows],
            self.speeds[rows],
            self.turn_rates[rows],
            unit=self.unit,
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


def _headings(headings: npt.ArrayLike, count: int) -> Floats:
    if isinstance(headings, str):
        raise InputError(
            f"headings: expected numbers, got {headings!r}; a team doesn't know where the pursuer "
            "is: disk.headings_away(positions) has the headings away from it"
        )
    each = one_each("headings", headings, count)
    return frozen_array("headings", each, (count,), LARGEST_HEADING)


def _turn_rates(
    speeds: Floats, turn_rates: npt.ArrayLike | None, turn_radii: npt.ArrayLike | None
) -> Floats:
    """Return the turn rates (N,), of which at most one argument tells, checked."""
    if turn_radii is None:
        given = DEFAULT_TURN_RATE if turn_rates is None else turn_rates
        return frozen_rates("turn_rates", given, len(speeds), infinite=True)
    if turn_rates is not None:
        raise InputError("turn_rates, turn_radii: expected one of them, got both; leave one out")
    return rates_of_radii(
        speeds, frozen_rates("turn_radii", turn_radii, len(speeds), infinite=True)
    )


def rates_of_radii(speeds: npt.ArrayLike, radii: npt.ArrayLike) -> Floats:
    """Return the turn rates ω = v/R (...) of evaders with speeds v and turning radii R (...)."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        rates = np.divide(speeds, radii)
    # With R = 0 an evader turns at once, also one that stands; so it does where R is all but 0.
    return read_only(np.where((np.asarray(radii) > 0.0) & (rates <= LARGEST), rates, np.inf))
