"""SciPy's SLSQP on eq. (6) as it stands: maximise z subject to z <= f_s for all N! sequences."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import minimize

from peers.enumeration import Sequences, capture_times, times_and_gradients
from peers.peer import Peer

TOLERANCE = 1e-9
"""Change of the survival time at which SLSQP stops."""


class Slsqp(Peer):
    """Sequential quadratic programming with the exact gradients of all N! times."""

    name = "SLSQP, exact gradients"
    largest = 7

    def __init__(self, count):
        self.sequences = Sequences(count)

    def solve(self, team, disk, turns, memory):
        """Return the turns of a local maximum, from `turns`; SLSQP has nothing to remember."""
        values, gradients = self._functions(team, disk)
        upwards = np.append(np.zeros(len(team)), -1.0)
        answer = minimize(
            lambda v: -v[-1],
            np.append(turns, values(np.append(turns, 0.0)).min()),
            jac=lambda v: upwards,
            bounds=[(-math.pi, math.pi)] * len(team) + [(0.0, None)],
            constraints={"type": "ineq", "fun": values, **gradients},
            method="SLSQP",
            options={"maxiter": 200, "ftol": TOLERANCE},
        )
        return np.clip(answer.x[:-1], -math.pi, math.pi), None

    def _functions(self, team, disk):
        """Return f_s - z for all sequences, and its gradients, computed once a point."""
        known = {}

        def both(v):
            key = v.tobytes()
            if key not in known:
                known.clear()
                known[key] = times_and_gradients(self.sequences, team, disk, v[:-1])
            return known[key]

        def gradients(v):
            slopes = both(v)[1]
            return np.column_stack([slopes, np.full(len(slopes), -1.0)])

        return lambda v: both(v)[0] - v[-1], {"jac": gradients}


class SlsqpByDifferences(Slsqp):
    """The same with forward differences, as a user of MATLAB's `fminimax` would have it."""

    name = "SLSQP, finite differences"

    def _functions(self, team, disk):
        def values(v):
            return capture_times(self.sequences, team, disk, v[:-1])[-1] - v[-1]

        return values, {}
