"""From an objective to what the kernels aim at."""

from __future__ import annotations

import numpy as np

from covey.kernels.maximum.objective import Aim
from covey.kernels.maximum.working_set import Columns
from covey.model import ExpectedSurvival, InputError, LastCapture, Objective, TotalSurvival
from covey.model.objectives import SequenceDistribution, distribution_of


def aim_of(objective: Objective, count: int) -> Aim:
    """Return an objective of `count` evaders as the kernels see it.

    Raises
    ------
    InputError
        If it is an expectation of another team, or over too many sequences.
    """
    sequences, probabilities = _draws(objective, count)
    return Aim(
        objective.measure == "total",
        isinstance(objective, ExpectedSurvival),
        Columns(np.full(1, len(sequences)), sequences, probabilities),
    )


def checked_objective(objective: object) -> Objective:
    """Return an objective, or raise InputError."""
    if not isinstance(objective, LastCapture | TotalSurvival | ExpectedSurvival):
        raise InputError(
            "objective: expected LastCapture(), TotalSurvival() or ExpectedSurvival(...), "
            f"got {objective!r}"
        )
    return objective


def _draws(objective: Objective, count: int) -> SequenceDistribution:
    if isinstance(objective, ExpectedSurvival):
        return distribution_of("ExpectedSurvival", objective.sequences, objective.weights, count)
    return SequenceDistribution(np.empty((0, count), np.int64), np.empty(0))
