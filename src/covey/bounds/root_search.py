"""Newton's method on the gradient of the last capture in a known sequence."""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.arrays import Pursuit
from covey.kernels.maximum.stationarity import stationarity
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
    first, gradient, hessian = stationarity(evaders, pursuit, sequence, root)
    last = first
    while True:
        # Row and step of an evader that is captured at time 0 are 0: its turn changes nothing.
        step = np.linalg.lstsq(hessian, -gradient)[0]
        length = float(np.abs(step).max())
        if not length < 0.5 * shortest:
            break
        root += step
        shortest = length
        last, gradient, hessian = stationarity(evaders, pursuit, sequence, root)
    return root if shortest <= _CONVERGED and last >= first * (1.0 - _ROUNDING) else None
