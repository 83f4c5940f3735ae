"""The pursuer as the team knows it: a disk that contains it, its speed, its capture radius."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from covey.model.team import Team
from covey.model.validation import (
    SMALLEST_SPEED,
    Floats,
    InputError,
    frozen_array,
    is_slower,
    number,
)


@dataclass(frozen=True, eq=False)
class PursuerDisk:
    """A pursuer of simple motion that is somewhere in a closed disk: D(x_c, r) of the paper.

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

    Raises
    ------
    InputError
        If a number is not finite or out of its range.

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

    def __init__(
        self,
        center: npt.ArrayLike = (0.0, 0.0),
        radius: float = 0.0,
        speed: float = 1.0,
        capture_radius: float = 0.0,
    ) -> None:
        positive = number("speed", speed, low=0.0, strictly=True)
        for name, value in (
            ("center", frozen_array("center", center, (2,))),
            ("radius", number("radius", radius, low=0.0)),
            ("speed", number("speed", positive, low=SMALLEST_SPEED)),
            ("capture_radius", number("capture_radius", capture_radius, low=0.0)),
        ):
            object.__setattr__(self, name, value)

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
