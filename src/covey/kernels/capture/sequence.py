"""One capture sequence: Algorithm 1, and the objective of its capture times."""

from __future__ import annotations

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.pursuit import Pursuit, disk_after, initial_disk


@compiled
def capture_times(paths: Floats, pursuit: Pursuit, sequence: Ints, times: Floats) -> float:
    """Algorithm 1: write the capture times in the order of `sequence`; return the last time."""
    disk, time = initial_disk(pursuit), 0.0
    for k in range(len(sequence)):
        time = earliest_capture(paths, sequence[k], disk)
        disk = disk_after(paths, sequence[k], time, pursuit)
        times[k] = time
    return time


@inlined
def objective_value(times: Floats, total: bool) -> float:
    """Return the last of some capture times, which don't decrease, or their sum."""
    if not total:
        return times[len(times) - 1]
    value = 0.0
    for k in range(len(times)):
        value += times[k]
    return value
