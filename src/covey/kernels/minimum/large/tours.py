"""Sequences from walks, and better sequences by moves of stretches: upper bounds."""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.pursuit import Pursuit, disk_after, initial_disk

_LONGEST_MOVED = 3  # evaders that move together; stretches of any length are reversed
_ROUNDING = 1e-12


@compiled
def repair(
    paths: Floats,
    pursuit: Pursuit,
    walk: Ints,
    sequence: Ints,
    times: Floats,
    trial: Ints,
) -> float:
    """Write a sequence like a walk, and its capture times; return the last time.

    Each evader stays where the walk captures it first; who is skipped comes in where the last
    capture is earliest.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    walk
        The last capture first.
    sequence, times
        (n,) modified in place.
    trial
        (n,) scratch.
    """
    n, captured, count = len(paths), 0, 0
    for k in range(len(walk) - 1, -1, -1):
        if not captured >> walk[k] & 1:
            captured |= 1 << walk[k]
            sequence[count] = walk[k]
            count += 1
    time = retime(paths, pursuit, 0, sequence[:count], times)
    for i in range(n):
        if not captured >> i & 1:
            sequence[count] = i
            count += 1
            time = _insert_last(paths, pursuit, sequence[:count], times, trial[:count])
    return time


@compiled
def _insert_last(
    paths: Floats, pursuit: Pursuit, sequence: Ints, times: Floats, trial: Ints
) -> float:
    """Move the last of a sequence to where the last capture is earliest; return that time."""
    count, best, least = len(sequence), len(sequence) - 1, math.inf
    for slot in range(count):
        _move(sequence, count - 1, 1, slot, False, trial)
        time = _last_capture(paths, pursuit, slot, trial, times, least)
        if time < least:
            best, least = slot, time
    _move(sequence, count - 1, 1, best, False, trial)
    for k in range(count):
        sequence[k] = trial[k]
    return retime(paths, pursuit, best, sequence, times)


@compiled
def improve(paths: Floats, pursuit: Pursuit, sequence: Ints, times: Floats, trial: Ints) -> float:
    """Move and reverse stretches of a sequence until none is better; return the last time.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    sequence, times
        (n,) the sequence and its capture times; modified in place.
    trial
        (n,) scratch.
    """
    n = len(sequence)
    least, before = retime(paths, pursuit, 0, sequence, times), math.inf
    while least < before:
        before = least
        for size in range(1, n + 1):
            for begin in range(n - size + 1):
                least = _improve_stretch(paths, pursuit, begin, size, sequence, times, trial, least)
    return least


@inlined
def _improve_stretch(
    paths: Floats,
    pursuit: Pursuit,
    begin: int,
    size: int,
    sequence: Ints,
    times: Floats,
    trial: Ints,
    least: float,
) -> float:
    """Move a stretch wherever it makes the last capture earlier; return that time."""
    n = len(sequence)
    first, last = begin, begin + 1
    if size <= _LONGEST_MOVED:
        first, last = 0, n - size + 1
    for slot in range(first, last):
        for backwards in range(slot == begin, 1 + (size > 1)):
            _move(sequence, begin, size, slot, backwards > 0, trial)
            bound = least * (1.0 - _ROUNDING)
            start = min(begin, slot)
            if _last_capture(paths, pursuit, start, trial, times, bound) < bound:
                for k in range(n):
                    sequence[k] = trial[k]
                least = retime(paths, pursuit, start, sequence, times)
    return least


@inlined
def _move(sequence: Ints, begin: int, size: int, slot: int, backwards: bool, trial: Ints) -> None:
    """Write the sequence in which a stretch has moved to a slot among the others."""
    for k in range(len(sequence)):
        if slot <= k < slot + size:
            source = begin + (slot + size - 1 - k if backwards else k - slot)
        else:
            source = k if k < slot else k - size
            source += size if source >= begin else 0
        trial[k] = sequence[source]


@inlined
def _next_capture(paths: Floats, pursuit: Pursuit, last: int, time: float, i: int) -> float:
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
        time = _next_capture(paths, pursuit, last, time, sequence[k])
        last, times[k] = sequence[k], time
    return time


@compiled
def _last_capture(
    paths: Floats, pursuit: Pursuit, begin: int, sequence: Ints, times: Floats, bound: float
) -> float:
    """Return the last capture of a sequence whose first times are known; or a time >= `bound`."""
    last, time = -1, 0.0
    if begin > 0:
        last, time = sequence[begin - 1], times[begin - 1]
    for k in range(begin, len(sequence)):
        if time >= bound:
            break
        time = _next_capture(paths, pursuit, last, time, sequence[k])
        last = sequence[k]
    return time
