"""The records of the outer maximisation of eq. (6): problem, iterate, options, counters."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels.arrays import Matrix, Vector
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.maximum.objective import Objective
from covey.kernels.maximum.working_set import WorkingSet

CONVERGED, STALLED, STEPS_USED_UP = range(3)
"""How an ascent ended."""

STEPS, INNER_SOLVES, INTERCEPTIONS = range(3)
"""Slots of an ascent's counters."""
COUNTERS = 3


class Problem(NamedTuple):
    """What is maximised: the objective of the living evaders' turns."""

    evaders: Matrix  # (n, EVADER) of the living
    pursuit: Pursuit
    objective: Objective


class Iterate(NamedTuple):
    """Where an ascent stands. Both are modified in place."""

    turns: Vector  # (n,) signed turns, radians in [-π, π]
    working_set: WorkingSet


class Options(NamedTuple):
    """How an ascent searches, and when it ends."""

    radius: float  # of the first trust region: the largest first change of a turn, radians
    tolerance: float  # a predicted gain below this, relative to the value, ends the ascent
    max_steps: int
