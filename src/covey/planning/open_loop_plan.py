"""What an open-loop plan is: its turns, what they guarantee, and how the search for them ended."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from covey.kernels.maximum.problem import CONVERGED, STALLED, STEPS_USED_UP
from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.model.display import html_table, one_line, quantity
from covey.model.validation import Floats
from covey.model.value import Value

CRITICAL_WITHIN = 1e-6
"""Sequences within this of the guaranteed time, relative, count as critical."""


class PlanStatus(StrEnum):
    """How the search for a plan ended.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> covey.plan(team, disk).status is covey.PlanStatus.CONVERGED
    True
    >>> covey.plan(team, disk, time_limit=0.0).status is covey.PlanStatus.TIME_LIMIT
    True
    """

    CONVERGED = "a local maximum, the best of all starts"
    STALLED = "the best of all starts, where rounding ended the ascent short of the tolerance"
    STEPS_USED_UP = "the best start was still rising when its steps were used up"
    TIME_LIMIT = "the time limit ended the search; the best turns found until then"


PLAN_STATUS = {
    CONVERGED: PlanStatus.CONVERGED,
    STALLED: PlanStatus.STALLED,
    STEPS_USED_UP: PlanStatus.STEPS_USED_UP,
}
"""What the kernels' numbers mean."""


@dataclass(frozen=True, eq=False)
class Plan(Value):
    """A plan for the whole team, and what it guarantees.

    Attributes
    ----------
    team, disk : Team, PursuerDisk
        The state of the game that was planned for.
    turns : numpy.ndarray
        (N,) signed turns δ in [-π, π], radians: turn by δ at full rate, then fly straight.
    goal_headings : numpy.ndarray
        (N,) headings φ after the turn, radians in [-π, π].
    survival_time : float
        Guaranteed against any pursuer in the disk: the minimum over all capture sequences at these
        turns, computed again after the search, from the turns alone. Exact for up to 20 evaders;
        for larger teams, where the minimum is not found in time, a proven lower bound of it.
    objective : LastCapture or TotalSurvival or ExpectedSurvival
        What the plan makes large.
    value : float
        Exact value of `objective` at these turns; `survival_time` where that is `LastCapture`.
    critical_sequences : tuple of tuple of int
        Capture sequences that attain the value, or come within 1e-6 of it, relative, as far as the
        search met them; the worst first. For an expectation, the sequences that it runs over.
    status : PlanStatus
    weights : tuple of float
        For each critical sequence the share with which it holds the plan where it is: the Lagrange
        multipliers of eq. (6), >= 0, summing to 1. For an expectation, their probabilities.
    starts, steps, interceptions : int
        What the search cost: ascents that ran to their end, steps of sequential quadratic
        programming, interceptions computed by the dynamic programme.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> plan = covey.plan(team, disk)
    >>> sorted(plan.critical_sequences)
    [(0, 1, 2), (1, 0, 2)]
    >>> print(plan.status)
    a local maximum, the best of all starts
    """

    team: Team
    disk: PursuerDisk
    turns: Floats
    goal_headings: Floats
    survival_time: float
    objective: Objective
    value: float
    critical_sequences: tuple[tuple[int, ...], ...]
    weights: tuple[float, ...]
    status: PlanStatus
    starts: int
    steps: int
    interceptions: int

    def __repr__(self) -> str:
        """Return what is guaranteed, and how the search ended, in one line."""
        named = {"survival_time": self.survival_time}
        if not isinstance(self.objective, LastCapture):
            named["value"] = self.value
        return one_line(
            "Plan",
            **{name: quantity(time, self.team.units.time) for name, time in named.items()},
            evaders=len(self.turns),
            critical_sequences=len(self.critical_sequences),
            status=self.status,
        )

    def _repr_html_(self) -> str:
        columns = {
            "evader": range(len(self.turns)),
            "turn (rad)": self.turns.tolist(),
            "goal heading (rad)": self.goal_headings.tolist(),
        }
        return html_table(repr(self), columns)
