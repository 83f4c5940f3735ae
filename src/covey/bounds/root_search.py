"""Newton's method on the gradient of the last capture in a known sequence."""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.capture.derivatives import (
    CAPTURE_ROW,
    Captures,
    add_curvature,
    differentiate,
)
from covey.kernels.capture.path import PATH, set_paths
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import capture_times
from covey.model.validation import Floats, Ints

_CONVERGED = 1e-6
"""Radians. After a Newton step as short as this the error is of the order of rounding."""

_ROUNDING = 1e-13
"""Relative rounding error of a last capture."""


def root_near(evaders: Floats, pursuit: Pursuit, sequence: Ints, turns: Floats) -> Floats | None:
    """Find turns near the given ones at which the gradient of the last capture vanishes.

    For unlimited turn rates. There the gradient vanishes if evader k flies along
    λ_k n_k - λ_{k+1} n_{k+1}, and the last one straight away from the capture before its own; see
    `plan_for_sequence`. Newton's method runs until rounding stops the steps from shrinking.

    Parameters
    ----------
    evaders
        (N, 5) rows of `Team.as_rows`.
    pursuit
        The pursuer, in the kernels' form.
    sequence
        (N,) the capture sequence.
    turns
        (N,) radians, near a maximum.

    Returns
    -------
    numpy.ndarray or None
        (N,) turns whose last capture is no earlier than at `turns`; None if the search diverges or
        ends at a lower value.
    """
    root, shortest = turns.copy(), math.inf
    first, gradient, hessian = _stationarity(evaders, pursuit, sequence, root)
    last = first
    while True:
        # Row and step of an evader that is captured at time 0 are 0: its turn changes nothing.
        step = np.linalg.lstsq(hessian, -gradient)[0]
        length = float(np.abs(step).max())
        if not length < 0.5 * shortest:
            break
        root += step
        shortest = length
        last, gradient, hessian = _stationarity(evaders, pursuit, sequence, root)
    return root if shortest <= _CONVERGED and last >= first * (1.0 - _ROUNDING) else None


def _stationarity(
    evaders: Floats, pursuit: Pursuit, sequence: Ints, turns: Floats
) -> tuple[float, Floats, Floats]:
    """Return the last capture, its gradient (N,) by the turns, and its Hessian (N, N)."""
    n = len(sequence)
    paths, gradient, lower = np.empty((n, PATH)), np.empty(n), np.zeros((n, n))
    captures = Captures(np.empty(n), np.empty((n, CAPTURE_ROW)), np.empty((3, n)))
    set_paths(evaders, turns, pursuit.speed, paths)
    last = capture_times(paths, pursuit, sequence, captures.times)
    differentiate(paths, pursuit, sequence, False, captures, gradient)
    add_curvature(paths, pursuit, sequence, captures, 1.0, lower)
    return last, gradient, np.tril(lower) + np.tril(lower, -1).T
