"""What a plan is worth: its expectation over drawn capture sequences, and any objective."""

from __future__ import annotations

import numpy.typing as npt

from covey.kernels.maximum.problem import Problem
from covey.kernels.maximum.values import mean_over_draws
from covey.model import (
    ExpectedSurvival,
    InputError,
    Objective,
    PursuerDisk,
    Team,
)
from covey.model.validation import checked_array, shown
from covey.planning.border import about_center, check_players, pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.guarantee import guaranteed_survival
from covey.planning.workspace import workspace


def expected_survival(
    team: Team, disk: PursuerDisk, turns: npt.ArrayLike, objective: ExpectedSurvival
) -> float:
    """Expected survival of a plan against a pursuer that draws its capture sequence.

    Parameters
    ----------
    team, disk
        The state of the game.
    turns
        (N,) signed turns δ, radians.
    objective
        The sequences, their probabilities, and whether the sum or the last capture is expected.

    Returns
    -------
    float
        The expected sum of all survival times, or the expected last capture. The pursuer flies each
        sequence as fast as possible (Algorithm 1).

    Raises
    ------
    InputError
        If an argument can't be used.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> any_order = covey.ExpectedSurvival(measure="last")
    >>> round(covey.expected_survival(team, disk, [0.0, 0.0, 0.0], any_order), 3)
    3.654
    """
    check_players(team, disk)
    if not isinstance(objective, ExpectedSurvival):
        raise InputError(f"objective: expected ExpectedSurvival(...), got {shown(objective)}")
    team, disk = about_center(team, disk)
    checked = checked_array("turns", turns, (len(team),))
    problem = Problem(team.as_rows(), pursuit_of(disk), compiled_objective(objective, len(team)))
    return mean_over_draws(problem, checked, workspace(len(team)))


def value_of_plan(
    team: Team, disk: PursuerDisk, turns: npt.ArrayLike, objective: Objective
) -> float:
    """Return the value of an objective at a plan's turns, guaranteed or expected."""
    if isinstance(objective, ExpectedSurvival):
        return expected_survival(team, disk, turns, objective)
    return guaranteed_survival(team, disk, turns, objective=objective).time
