"""Two times between which the true value of the game lies."""

from __future__ import annotations

import math
from dataclasses import dataclass

from covey.bounds.announced_sequence import best_announcement
from covey.bounds.fixed_sequence import SequencePlan, plan_for_sequence
from covey.bounds.polygon_bound import latest_capture
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors
from covey.planning.open_loop import Plan, plan

_MOVES = 8
"""How often the pursuer's place in the disk is improved."""


@dataclass(frozen=True, eq=False)
class Bracket:
    """Bounds on how long a team can be sure to survive, whatever its strategy.

    Attributes
    ----------
    lower : float
        The team survives at least so long: the guaranteed time of `plan`.
    upper : float
        No team could be sure of more, even if it saw the pursuer and turned at once: the pursuer
        may announce `sequence` and still has captured everybody by then.
    plan : Plan
        The open-loop plan that `lower` is the guarantee of.
    sequence : tuple of int
        The capture sequence that `upper` belongs to.
    """

    lower: float
    upper: float
    plan: Plan
    sequence: tuple[int, ...]


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
        The value lies in [lower, upper], up to rounding.

    Raises
    ------
    InputError
        If an argument can't be used.

    Notes
    -----
    Above stands the fixed-sequence value for unlimited turn rates, the least over the sequences
    that a search came to. It bounds the game because a pursuer that keeps to a sequence, and makes
    for each evader with the line of sight at a constant bearing, needs no longer, whatever the
    evaders do meanwhile: docs/decisions/0006. That the maximum over their headings is the global
    one, and not a local one below it, is proven anew in each call: the bound is taken over corners
    of polygons that contain all velocities. In 700 random games of three and five it exceeded the
    maximum that was found by less than 1e-11, relative.

    Every pursuer that the rules allow bounds the value. So where it starts in a disk, the best
    place found is taken. With a capture radius ρ it makes use of its reach only at the last
    capture: until then it comes to the very place of each evader, as if one that was captured on
    the way had flown on.

    References
    ----------
    .. [1] A. A. Chikrii, L. A. Sobolenko, S. F. Kalashnikova, "A numerical method for the solution
       of the successive pursuit-and-evasion problem", Cybernetics 24 (1988).
    .. [2] A. Belousov, Y. Berdyshev, A. Chentsov, A. Chikrii, "Solving the dynamic traveling
       salesman game problem", Cybernetics and Systems Analysis 46 (2010).
    """
    found = plan(team, disk, seed=seed, starts=starts)
    agile = Team(team.positions, team.headings, team.speeds, math.inf)
    point = PursuerDisk(disk.center, disk.radius, disk.speed)
    announced = best_announcement(agile, point, found.critical_sequences[:2])
    start, announced = _from_best_place(agile, disk, announced)
    upper = latest_capture(agile, start, announced)
    return Bracket(
        lower=found.survival_time,
        upper=max(upper, found.survival_time),  # equal, but for rounding, where it is exact
        plan=found,
        sequence=announced.sequence,
    )


def _from_best_place(
    team: Team, disk: PursuerDisk, announced: SequencePlan
) -> tuple[PursuerDisk, SequencePlan]:
    """Return the pursuer at a good place in its disk, and the team's answer to it.

    The nearest to the first capture, again and again, as the team answers each.
    """
    best: tuple[PursuerDisk, SequencePlan] | None = None
    for _ in range(_MOVES):
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
