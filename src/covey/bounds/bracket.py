"""A lower and an upper bound of the true value of the game."""

from __future__ import annotations

import math
from dataclasses import dataclass

from covey.bounds.announced_sequence import best_announcement
from covey.bounds.fixed_sequence import SequencePlan, plan_for_sequence
from covey.bounds.polygon_bound import last_capture_bound
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors
from covey.model.display import html_table, one_line
from covey.model.validation import Floats, read_only
from covey.model.value import Value
from covey.planning.guarantee import about_center
from covey.planning.open_loop import Plan, plan

_MAX_IMPROVEMENTS = 8
"""Improvements of the pursuer's start in its disk, at most."""


@dataclass(frozen=True, eq=False)
class Bracket(Value):
    """Bounds on the survival time that a team can guarantee, whatever its strategy.

    Attributes
    ----------
    lower : float
        The guaranteed survival time of `plan`.
    upper : float
        No strategy guarantees more, even if the team sees the pursuer and turns at once: a pursuer
        that announces `sequence` has captured everybody by this time.
    plan : Plan
        The open-loop plan that guarantees `lower`.
    sequence : tuple of int
        The capture sequence whose value is `upper`.
    start : numpy.ndarray
        (2,) the point of the disk from which that pursuer starts.
    """

    lower: float
    upper: float
    plan: Plan
    sequence: tuple[int, ...]
    start: Floats

    def __repr__(self) -> str:
        """Return both bounds, and the sequence of the upper one, in one line."""
        return one_line("Bracket", lower=self.lower, upper=self.upper, sequence=self.sequence)

    def _repr_html_(self) -> str:
        row = {"lower": self.lower, "upper": self.upper, "sequence": self.sequence}
        return html_table("Bracket", {name: [value] for name, value in row.items()})


def bracket(team: Team, disk: PursuerDisk, *, seed: int = 0, starts: int | None = None) -> Bracket:
    """Bracket the true value of the game from below and above.

    Parameters
    ----------
    team, disk
        The state of the game; up to 20 evaders, each slower than the pursuer.
    seed, starts
        Of the search for the plan, see `covey.plan`.

    Returns
    -------
    Bracket
        The value lies in [lower, upper], up to rounding, by which equal bounds may cross.

    Raises
    ------
    InputError
        If an argument can't be used.

    Notes
    -----
    The upper bound is the fixed-sequence value for unlimited turn rates, the least over the
    sequences that a search visits. A pursuer that keeps to a sequence, and flies to each evader
    with the line of sight at a constant bearing, captures the last one no later, whatever the
    evaders do (docs/decisions/0006).

    The fixed-sequence value is a maximum over headings. Each call proves that no higher maximum was
    missed: the bound is computed at the corners of polygons that contain all velocities. In 700
    random games of three and five evaders it exceeded the maximum found by less than 1e-11,
    relative.

    Every start in the disk gives a bound. The bounding pursuer starts at the best position that a
    few improvements find. It uses the capture radius ρ for the last capture only. Before that it
    flies to each evader's exact position, and an evader that it passes within ρ counts as still
    flying.

    References
    ----------
    .. [1] A. A. Chikrii, L. A. Sobolenko, S. F. Kalashnikova, "A numerical method for the solution
       of the successive pursuit-and-evasion problem", Cybernetics 24 (1988).
    .. [2] A. Belousov, Y. Berdyshev, A. Chentsov, A. Chikrii, "Solving the dynamic traveling
       salesman game problem", Cybernetics and Systems Analysis 46 (2010).
    """
    found = plan(team, disk, seed=seed, starts=starts)
    center = disk.center
    team, disk = about_center(team, disk)
    agile = Team(team.positions, team.headings, team.speeds, math.inf)
    point = PursuerDisk(disk.center, disk.radius, disk.speed)
    announced = best_announcement(agile, point, found.critical_sequences[:2])
    start, announced = _from_best_start(agile, disk, announced)
    return Bracket(
        lower=found.survival_time,
        upper=last_capture_bound(agile, start, announced),
        plan=found,
        sequence=announced.sequence,
        start=read_only(center + start.center),
    )


def _from_best_start(
    team: Team, disk: PursuerDisk, announced: SequencePlan
) -> tuple[PursuerDisk, SequencePlan]:
    """Return the pursuer at a good position in its disk, and the team's best answer.

    The pursuer moves to the point nearest to the first capture and the team answers, until the last
    capture comes no earlier.
    """
    best: tuple[PursuerDisk, SequencePlan] | None = None
    for _ in range(_MAX_IMPROVEMENTS):
        first = announced.sequence[0]
        heading, time = announced.goal_headings[first], announced.capture_times[0]
        goal = team.positions[first] + team.speeds[first] * time * unit_vectors(heading)
        start = PursuerDisk(disk.nearest_point(goal), 0.0, disk.speed, disk.capture_radius)
        point = PursuerDisk(start.center, 0.0, disk.speed)
        announced = plan_for_sequence(team, point, announced.sequence)
        if best is not None and announced.survival_time >= best[1].survival_time:
            break
        best = start, announced
    assert best is not None
    return best
