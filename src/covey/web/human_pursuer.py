"""The pursuer that a person steers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from covey.model import PursuerDisk
from covey.model.validation import Floats
from covey.simulation import Fly, PursuerPolicy, Situation

Point = tuple[float, float]


class HumanPursuer:
    """Flies at full speed to the point, or in the direction, that was steered for last.

    Parameters
    ----------
    update_time
        Between decisions: a point that is nearer than one flight is flown to, and not past.
    """

    def __init__(self, update_time: float) -> None:
        self._update_time = update_time
        self._target: Point | None = None
        self._heading: float | None = None

    def steer(self, target: Point | None, heading: float | None) -> None:
        """Make for a point or, without one, fly a heading in radians; without either, wait."""
        self._target, self._heading = target, heading

    def describe(self) -> Mapping[str, Any]:
        """Return the name that stands in the record."""
        return {"name": "person"}

    def place(self, disk: PursuerDisk) -> Floats:
        """Return where it is at time 0, also where the team doesn't see it: the disk's centre."""
        return disk.center

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return self._decide

    def _decide(self, situation: Situation) -> Fly:
        speed, heading = situation.disk.speed, self._heading
        if self._target is not None:
            x, y = situation.pursuer.center.tolist()
            off_x, off_y = self._target[0] - x, self._target[1] - y
            speed = min(speed, math.hypot(off_x, off_y) / self._update_time)
            heading = math.atan2(off_y, off_x)
        if heading is None:
            return Fly()
        return Fly((speed * math.cos(heading), speed * math.sin(heading)))
