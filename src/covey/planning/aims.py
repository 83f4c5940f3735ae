"""From an objective to what the kernels aim at."""

from __future__ import annotations

import numpy as np

from covey.kernels.aim import Aim
from covey.kernels.columns import Columns
from covey.kernels.totals import MOST_IN_TOTAL
from covey.model import ExpectedSurvival, InputError, LastCapture, Objective, TotalSurvival
from covey.model.objectives import Draws, draws_of


def aim_of(objective: Objective, count: int) -> Aim:
    """Return an objective of `count` evaders as the kernels see it.

    Raises
    ------
    InputError
        If it is one of another team, or the team is too large for it.
    """
    expected, total = isinstance(objective, ExpectedSurvival), objective.measure == "total"
    if isinstance(objective, TotalSurvival) and count > MOST_IN_TOTAL:
        raise InputError(
            f"objective: expected at most {MOST_IN_TOTAL} evaders for the sum of survival times, "
            f"got {count}; it needs 80 N 2^N bytes"
        )
    sequences, probabilities = _draws(objective, count)
    return Aim(total, expected, Columns(np.full(1, len(sequences)), sequences, probabilities))


def checked_objective(objective: object) -> Objective:
    """Return an objective, or raise InputError."""
    if not isinstance(objective, LastCapture | TotalSurvival | ExpectedSurvival):
        raise InputError(
            "objective: expected LastCapture(), TotalSurvival() or ExpectedSurvival(...), "
            f"got {objective!r}"
        )
    return objective


def _draws(objective: Objective, count: int) -> Draws:
    if isinstance(objective, ExpectedSurvival):
        return draws_of("ExpectedSurvival", objective.sequences, objective.weights, count)
    return Draws(np.empty((0, count), np.int64), np.empty(0))
