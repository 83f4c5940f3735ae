"""One capture sequence: Algorithm 1, its rest, and the objective of its capture times."""

from __future__ import annotations

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Floats, Ints, IntVector, Matrix, Vector
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
def next_capture(paths: Floats, pursuit: Pursuit, last: int, time: float, i: int) -> float:
    """Return when i is captured after `last` was captured at `time`; as the first if that is -1."""
    disk = disk_after(paths, last, time, pursuit) if last >= 0 else initial_disk(pursuit)
    return earliest_capture(paths, i, disk)


@compiled
def retime(paths: Floats, pursuit: Pursuit, begin: int, sequence: Ints, times: Floats) -> float:
    """Write the times of a sequence from its slot `begin` on; return the last time."""
    last, time = -1, 0.0
    if begin > 0:
        last, time = sequence[begin - 1], times[begin - 1]
    for k in range(begin, len(sequence)):
        time = next_capture(paths, pursuit, last, time, sequence[k])
        last, times[k] = sequence[k], time
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
