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
    """Flies at full speed to the point, or along the heading, of the last `steer`.

    Parameters
    ----------
    update_time
        Time between decisions. The pursuer slows down for a point that it would fly past.
    """

    def __init__(self, update_time: float) -> None:
        self._update_time = update_time
        self._target: Point | None = None
        self._heading: float | None = None

    def steer(self, target: Point | None, heading: float | None) -> None:
        """Fly to `target` or, if None, along `heading`, radians; if both are None, wait."""
        self._target, self._heading = target, heading

    def describe(self) -> Mapping[str, Any]:
        """Return the entry of the record."""
        return {"name": "person"}

    def place(self, disk: PursuerDisk) -> Floats:
        """Return the position at time 0, the disk's centre, also if the team doesn't see it."""
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
