"""One capture sequence: Algorithm 1, and the objective of its capture times."""

from __future__ import annotations

from covey.kernels._jit import entry, inlined
from covey.kernels.arrays import Floats, IntVector, Matrix, Vector
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.pursuit import Pursuit, disk_after, initial_disk


@entry
def capture_times(paths: Matrix, pursuit: Pursuit, sequence: IntVector, times: Vector) -> float:
    """Algorithm 1: write the capture times in the order of `sequence`; return the last time.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    sequence
        (m,) numbers of evaders, each at most once.
    times
        (m,) modified in place.
    """
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
