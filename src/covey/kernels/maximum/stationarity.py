"""The stationarity conditions of a known sequence, and how they change from turn to turn."""

from __future__ import annotations

import numpy as np

from covey.kernels._jit import allocating
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.path import PATH, set_paths
from covey.kernels.capture.sequence import CAPTURE, add_curvature, capture_times, differentiate


@allocating
def stationarity(
    evaders: Table, pursuit: Pursuit, sequence: Ints, turns: Floats
) -> tuple[float, Floats, Table]:
    """The last capture of a known sequence, its gradient (N,) by the turns, its Hessian (N, N)."""
    n = len(sequence)
    paths, times, captures = np.empty((n, PATH)), np.empty(n), np.empty((n, CAPTURE))
    gradient, hessian = np.empty(n), np.zeros((n, n))
    set_paths(evaders, turns, pursuit.speed, paths)
    last = capture_times(paths, pursuit, sequence, times)
    differentiate(paths, pursuit, sequence, False, times, captures, gradient)
    add_curvature(paths, pursuit, sequence, times, captures, 1.0, np.empty((3, n)), hessian)
    for i in range(n):
        for j in range(i):
            hessian[j, i] = hessian[i, j]
    return last, gradient, hessian
