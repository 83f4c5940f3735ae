"""The root search for the best straight flights against a known sequence."""

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

_FOUND = 1e-6
"""Radians. A Newton step as short as this squares the error: the next one is lost in rounding."""

_ROUNDING = 1e-13
"""Relative, of a last capture."""


def root_near(evaders: Floats, pursuit: Pursuit, sequence: Ints, turns: Floats) -> Floats | None:
    """Find the turns near those given at which the last capture has no gradient.

    For unlimited turn rates, where the last capture has no gradient as soon as evader k flies along
    λ_k n_k - λ_{k+1} n_{k+1}, and the last one straight away from the place of the capture before
    its own; see `plan_for_sequence`. Newton's method, on until rounding is all that is left.

    Parameters
    ----------
    evaders
        (N, 5) as the kernels have them.
    pursuit, sequence
        The game, and the order of capture.
    turns
        (N,) near a maximum.

    Returns
    -------
    numpy.ndarray or None
        (N,) turns with a last capture no earlier; None where the search leads elsewhere.
    """
    root, shortest = turns.copy(), math.inf
    first, gradient, hessian = _stationarity(evaders, pursuit, sequence, root)
    last = first
    while True:
        # An evader that is captured where it stands has no say: its row is 0, and so is its step.
        step = np.linalg.lstsq(hessian, -gradient)[0]
        length = float(np.abs(step).max())
        if not length < 0.5 * shortest:
            break
        root += step
        shortest = length
        last, gradient, hessian = _stationarity(evaders, pursuit, sequence, root)
    return root if shortest <= _FOUND and last >= first * (1.0 - _ROUNDING) else None


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
