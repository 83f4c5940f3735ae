"""From an objective to the record that the kernels read."""

from __future__ import annotations

import numpy as np

from covey.kernels.maximum.objective import Draws as CompiledDraws
from covey.kernels.maximum.objective import Objective as CompiledObjective
from covey.model import ExpectedSurvival, InputError, LastCapture, Objective, TotalSurvival
from covey.model.objectives import OBJECTIVES, SequenceDistribution, distribution_of
from covey.model.validation import choice, shown


def compiled_objective(objective: Objective, count: int) -> CompiledObjective:
    """Return an objective of `count` evaders as the kernels see it.

    Raises
    ------
    InputError
        If it is an expectation of another team, or over too many sequences.
    """
    sequences, probabilities = _draws(objective, count)
    return CompiledObjective(
        objective.measure == "total",
        isinstance(objective, ExpectedSurvival),
        CompiledDraws(np.full(1, len(sequences)), sequences, probabilities),
    )


def checked_objective(objective: object) -> Objective:
    """Return an objective, given as a value or by its name, or raise InputError."""
    if isinstance(objective, str):
        return OBJECTIVES[choice("objective", objective, list(OBJECTIVES))]()
    if not isinstance(objective, LastCapture | TotalSurvival | ExpectedSurvival):
        raise InputError(
            "objective: expected LastCapture(), TotalSurvival() or ExpectedSurvival(...), "
            f"got {shown(objective)}"
        )
    return objective


def _draws(objective: Objective, count: int) -> SequenceDistribution:
    if isinstance(objective, ExpectedSurvival):
        return distribution_of("ExpectedSurvival", objective.sequences, objective.weights, count)
    return SequenceDistribution(np.empty((0, count), np.int64), np.empty(0))
