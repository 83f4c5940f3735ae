"""Sequences from walks, and better sequences by moves of stretches: upper bounds."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import Floats, Ints
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import next_capture, retime

_LONGEST_MOVED = 3  # evaders that move together; stretches of any length are reversed
_ROUNDING = 1e-12


class Tour(NamedTuple):
    """A sequence that is changed by moves."""

    sequence: Ints  # (n,)
    times: Floats  # (n,) its capture times
    trial: Ints  # (n,) the sequence after a move that is tried


@compiled
def repair(paths: Floats, pursuit: Pursuit, walk: Ints, tour: Tour) -> float:
    """Make a walk, the last capture first, into a sequence; return the last time.

    Each evader stays where the walk captures it first; who is skipped comes in where the last
    capture is earliest. The tour is modified in place.
    """
    n, captured, count = len(paths), 0, 0
    for k in range(len(walk) - 1, -1, -1):
        if not captured >> walk[k] & 1:
            captured |= 1 << walk[k]
            tour.sequence[count] = walk[k]
            count += 1
    time = retime(paths, pursuit, 0, tour.sequence[:count], tour.times)
    for i in range(n):
        if not captured >> i & 1:
            tour.sequence[count] = i
            count += 1
            time = _insert_last(paths, pursuit, count, tour)
    return time


@compiled
def _insert_last(paths: Floats, pursuit: Pursuit, count: int, tour: Tour) -> float:
    """Move the last of `count` evaders to where the last capture is earliest; return that time."""
    sequence, trial = tour.sequence[:count], tour.trial[:count]
    best, least = count - 1, math.inf
    for slot in range(count):
        _move(sequence, count - 1, 1, slot, False, trial)
        time = _last_capture(paths, pursuit, slot, count, trial, tour.times, least)
        if time < least:
            best, least = slot, time
    _move(sequence, count - 1, 1, best, False, trial)
    for k in range(count):
        sequence[k] = trial[k]
    return retime(paths, pursuit, best, sequence, tour.times)


@compiled
def improve(paths: Floats, pursuit: Pursuit, tour: Tour) -> float:
    """Move and reverse stretches of a tour until none is better; return the last time."""
    n = len(tour.sequence)
    least, before = retime(paths, pursuit, 0, tour.sequence, tour.times), math.inf
    while least < before:
        before = least
        for size in range(1, n + 1):
            for begin in range(n - size + 1):
                least = _improve_stretch(paths, pursuit, begin, size, least, tour)
    return least


@inlined
def _improve_stretch(
    paths: Floats, pursuit: Pursuit, begin: int, size: int, least: float, tour: Tour
) -> float:
    """Move a stretch wherever it makes the last capture earlier; return that time."""
    sequence, trial = tour.sequence, tour.trial
    first, last = begin, begin + 1
    if size <= _LONGEST_MOVED:
        first, last = 0, len(sequence) - size + 1
    for slot in range(first, last):
        for backwards in range(slot == begin, 1 + (size > 1)):
            _move(sequence, begin, size, slot, backwards > 0, trial)
            bound = least * (1.0 - _ROUNDING)
            start, end = min(begin, slot), max(begin, slot) + size
            if _last_capture(paths, pursuit, start, end, trial, tour.times, bound) < bound:
                for k in range(len(sequence)):
                    sequence[k] = trial[k]
                least = retime(paths, pursuit, start, sequence, tour.times)
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


@compiled
def _last_capture(
    paths: Floats,
    pursuit: Pursuit,
    begin: int,
    end: int,
    sequence: Ints,
    times: Floats,
    bound: float,
) -> float:
    """Return the last capture of a sequence after a move, or a time >= `bound`.

    The move changed the slots from `begin` up to `end`. `times` are those before the move. Where an
    evader after the move is captured no earlier than before, so are all that follow.
    """
    last, time = -1, 0.0
    if begin > 0:
        last, time = sequence[begin - 1], times[begin - 1]
    for k in range(begin, len(sequence)):
        if time >= bound:
            break
        time = next_capture(paths, pursuit, last, time, sequence[k])
        last = sequence[k]
        if k >= end and time >= times[k]:
            return math.inf
    return time
