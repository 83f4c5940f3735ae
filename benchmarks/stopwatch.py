"""A clock that compiled code can read, so that what Python adds to a call isn't measured."""

from __future__ import annotations

import ctypes
import time

import numba
import numpy as np

_MONOTONIC = time.CLOCK_MONOTONIC
_clock_gettime = ctypes.CDLL(None).clock_gettime
_clock_gettime.argtypes = [ctypes.c_int, ctypes.c_void_p]
_clock_gettime.restype = ctypes.c_int


@numba.njit
def now(reading):
    """Seconds since some moment; `reading` is scratch, (2,) ints. A call takes about 30 ns."""
    _clock_gettime(_MONOTONIC, reading.ctypes)
    return reading[0] + 1e-9 * reading[1]


def seconds_of(kernel):
    """Return a compiled function of (calls, arguments): seconds that a call of `kernel` takes.

    The median of five means over that many calls.
    """

    @numba.njit
    def median(calls, arguments):
        reading, means = np.zeros(2, np.int64), np.empty(5)
        kernel(*arguments)
        for k in range(5):
            start = now(reading)
            for _ in range(calls):
                kernel(*arguments)
            means[k] = (now(reading) - start) / calls
        return np.median(means)

    return median
