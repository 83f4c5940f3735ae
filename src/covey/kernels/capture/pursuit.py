"""The pursuer as the kernels see it: a disk that grows, and collapses at each capture."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import inlined
from covey.kernels.arrays import Floats
from covey.kernels.capture.path import position


class Pursuit(NamedTuple):
    """A pursuer that is somewhere in a disk and captures within a distance.

    `first_radius` is r + ρ: from anywhere in the disk the first capture happens within ρ.
    `later_radius` is 2ρ: after a capture at x_j the pursuer is within ρ of x_j, and captures the
    next evader within ρ.
    """

    center_x: float
    center_y: float
    first_radius: float
    later_radius: float
    speed: float


class GrowingDisk(NamedTuple):
    """The disk D((x, y), radius + speed (t - time)) in which an evader is captured at t."""

    x: float
    y: float
    radius: float
    time: float
    speed: float


@inlined
def initial_disk(pursuit: Pursuit) -> GrowingDisk:
    """Return the disk of the first capture."""
    return GrowingDisk(pursuit.center_x, pursuit.center_y, pursuit.first_radius, 0.0, pursuit.speed)


@inlined
def disk_after(paths: Floats, i: int, time: float, pursuit: Pursuit) -> GrowingDisk:
    """Return the disk of the next capture after evader i was captured at `time`.

    The step of Algorithm 1: the disk collapses to the capture point.
    """
    x, y = position(paths, i, time)
    return GrowingDisk(x, y, pursuit.later_radius, time, pursuit.speed)
