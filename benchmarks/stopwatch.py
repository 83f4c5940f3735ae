"""A clock that compiled code can read, so that what Python adds to a call isn't measured."""

from __future__ import annotations

import ctypes
import time

import numba
import numpy as np

_CALLS = 4
_MONOTONIC = time.CLOCK_MONOTONIC
_clock_gettime = ctypes.CDLL(None).clock_gettime
_clock_gettime.argtypes = [ctypes.c_int, ctypes.c_void_p]
_clock_gettime.restype = ctypes.c_int


@numba.njit
def now(reading):
    """Seconds since some moment; `reading` is scratch, (2,) ints. A call takes about 30 ns."""
    _clock_gettime(_MONOTONIC, reading.ctypes)
    return reading[0] + 1e-9 * reading[1]


def seconds_of_one(kernel):
    """Return a compiled function of (arguments,): seconds that a call of `kernel` takes.

    The median of five means over several calls, which is for short ones: a processor that learns
    the branches of a long one makes it twice as fast.
    """

    @numba.njit
    def seconds(arguments):
        reading, means = np.zeros(2, np.int64), np.empty(5)
        kernel(*arguments)
        for k in range(len(means)):
            start = now(reading)
            for _ in range(_CALLS):
                kernel(*arguments)
            means[k] = (now(reading) - start) / _CALLS
        return np.median(means)

    return seconds


def seconds_of_all(kernel):
    """Return a compiled function of (list of arguments,): seconds that calls in this order take.

    The median of three passes over the list, which is for long calls: a list costs 0.1 µs each.
    """

    @numba.njit
    def seconds(calls):
        reading, passes = np.zeros(2, np.int64), np.empty(4)
        for k in range(len(passes)):
            start = now(reading)
            for arguments in calls:
                kernel(*arguments)
            passes[k] = now(reading) - start
        return np.median(passes[1:])

    return seconds
