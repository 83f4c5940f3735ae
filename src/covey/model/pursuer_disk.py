"""The pursuer as the team knows it: a disk that contains it, its speed, its capture radius."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from covey.model.angles import away_from
from covey.model.display import html_row, one_line, quantity
from covey.model.team import Team
from covey.model.units import Units, titled, units_with
from covey.model.validation import (
    SMALLEST_SPEED,
    Floats,
    InputError,
    checked_array,
    frozen_array,
    is_slower,
    number,
    unit_name,
)
from covey.model.value import Value


@dataclass(frozen=True, eq=False)
class PursuerDisk(Value):
    """A pursuer of simple motion that is somewhere in a closed disk: D(x_c, r) of the paper.

    Disks with equal numbers are equal, and have equal hashes.

    Parameters
    ----------
    center
        (2,), lengths.
    radius
        r >= 0, a length; 0 where the pursuer's position is known.
    speed
        v_p > 0 (at least 1e-50), length per time.
    capture_radius
        ρ >= 0, a length: the pursuer captures an evader within this distance. The paper's game has
        ρ = 0.
    unit
        The unit of all lengths of the game, as in `Team`. Default: no unit is named.

    Raises
    ------
    InputError
        If a number is not finite or out of its range, or the unit isn't a short word.

    Examples
    --------
    >>> import covey
    >>> disk = covey.PursuerDisk(center=(0.0, 0.0), radius=0.15, capture_radius=0.03)
    >>> disk.radius, disk.speed
    (0.15, 1.0)
    """

    center: Floats
    radius: float
    speed: float
    capture_radius: float
    unit: str

    def __init__(
        self,
        center: npt.ArrayLike = (0.0, 0.0),
        radius: float = 0.0,
        speed: float = 1.0,
        capture_radius: float = 0.0,
        *,
        unit: str = "",
    ) -> None:
        positive = number("speed", speed, low=0.0, strictly=True)
        for name, value in (
            ("center", frozen_array("center", center, (2,))),
            ("radius", number("radius", radius, low=0.0)),
            ("speed", number("speed", positive, low=SMALLEST_SPEED)),
            ("capture_radius", number("capture_radius", capture_radius, low=0.0)),
            ("unit", unit_name("unit", unit)),
        ):
            object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        """Return all numbers in one line."""
        numbers = {name: quantity(value, unit) for name, value, unit in self._numbers()}
        return one_line("PursuerDisk", **numbers)

    def _repr_html_(self) -> str:
        facts = {titled(name.replace("_", " "), u): value for name, value, u in self._numbers()}
        return html_row("PursuerDisk", facts)

    def _numbers(self) -> Iterator[tuple[str, object, str]]:
        """Return the name, the value and the unit of each number."""
        length, _, speed, _ = self.units
        yield "center", tuple(self.center.tolist()), length
        yield "radius", self.radius, length
        yield "speed", self.speed, speed
        yield "capture_radius", self.capture_radius, length

    @property
    def units(self) -> Units:
        """What tables and pictures write beside lengths, times, speeds and turn rates."""
        return units_with(self.unit)

    @classmethod
    def last_seen(
        cls,
        position: npt.ArrayLike,
        *,
        within: float = 0.0,
        ago: float,
        speed: float = 1.0,
        capture_radius: float = 0.0,
        unit: str = "",
    ) -> PursuerDisk:
        """Return the disk of a pursuer that was last seen some time ago.

        Parameters
        ----------
        position
            (2,) where the pursuer was seen.
        within
            >= 0, the length by which that sighting may be wrong.
        ago
            >= 0, the time since then.
        speed, capture_radius, unit
            As above.

        Returns
        -------
        PursuerDisk
            Around `position`, with r = within + v_p ago: the pursuer may have flown straight in
            any direction.

        Raises
        ------
        InputError
            If a number is not finite or out of its range.

        Examples
        --------
        >>> covey.PursuerDisk.last_seen((0.0, 0.0), within=150.0, ago=12.0, speed=45.0).radius
        690.0
        """
        speed = number("speed", speed, low=0.0, strictly=True)
        radius = number("within", within, low=0.0) + speed * number("ago", ago, low=0.0)
        return cls(position, radius, speed, capture_radius, unit=unit)

    def headings_away(self, positions: npt.ArrayLike) -> Floats:
        """Return the headings (N,), radians, straight away from the centre at `positions` (N, 2).

        Raises
        ------
        InputError
            If a position is the centre, from where every heading leads away.
        """
        checked = checked_array("positions", positions, (None, 2))
        at_center = np.flatnonzero((checked == self.center).all(axis=1))
        if at_center.size:
            raise InputError(
                f"positions: expected none at the disk's centre, from where every heading leads "
                f"away, got positions[{at_center[0]}]; choose the heading of this evader yourself"
            )
        return away_from(self.center, checked)

    def moved(self, by: Floats) -> PursuerDisk:
        """Return the disk, moved `by` (2,)."""
        return replace(self, center=self.center + by)

    def towards(self, goal: Floats, lengths: npt.ArrayLike) -> Floats:
        """Return the points `lengths` (...) from the centre on the way to `goal` (2,), as (..., 2).

        The way ends at `goal`: a greater length leads no farther.
        """
        offset = goal - self.center
        distance = float(np.hypot(*offset))
        direction = offset / distance if distance > 0.0 else offset
        points: Floats = self.center + np.minimum(lengths, distance)[..., np.newaxis] * direction
        return points

    def nearest_point(self, goal: Floats) -> Floats:
        """Return the point (2,) of the disk that is nearest to `goal` (2,)."""
        return self.towards(goal, self.radius)

    def require_faster_than(self, team: Team) -> None:
        """Raise InputError unless every evader `is_slower`; another could flee for ever."""
        fastest = int(team.speeds.argmax())
        if not is_slower(team.speeds[fastest], self.speed):
            raise InputError(
                "speeds: expected every evader to be slower than the pursuer "
                f"({self.speed:.12g}), got speeds[{fastest}] = {team.speeds[fastest]:.12g}"
            )
