"""When the pursuer captures an evader if it makes for that one at once."""

from __future__ import annotations

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Table
from covey.kernels.capture.interception import earliest_capture


@compiled
def earliest_captures(
    paths: Table, x: float, y: float, radius: float, start: float, speed: float, times: Floats
) -> None:
    """Write the earliest capture of each path by a disk that grows from time `start` on."""
    for i in range(len(paths)):
        times[i] = earliest_capture(paths, i, x, y, radius, start, speed)
