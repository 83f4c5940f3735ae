"""A lower and an upper bound of the true value of the game."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from covey.bounds.next_capture import next_capture_bound
from covey.bounds.upper_end import earliest_end
from covey.model import PursuerDisk, Team
from covey.model.display import html_row, one_line, quantity
from covey.model.units import titled
from covey.model.validation import Floats, read_only
from covey.model.value import Value
from covey.planning import ContingentPlan, Plan, plan, plan_contingent
from covey.planning.border import about_center

_DEPTHS = {6: 2, 7: 2, 8: 1, 9: 1}
"""Captures that the contingent plan of larger teams answers by default: about a second's work."""


class LowerEnd(StrEnum):
    """What guarantees the lower end of a bracket."""

    OPEN_LOOP = "open-loop plan"
    CONTINGENT = "contingent plan"


class UpperEndKind(StrEnum):
    """How the pursuer of the upper end of a bracket is sure of its time."""

    AGILE = "announced sequence, against evaders that turn at once"
    TURN_LIMITS = "announced sequence, against evaders with their turn rates"
    NEXT_CAPTURE = "announced next capture, against evaders that turn at once"


class UpperBound(NamedTuple):
    """A time by which a pursuer has captured everybody, whatever the team does; see `Bracket`."""

    time: float
    by: UpperEndKind
    sequence: tuple[int, ...]
    start: Floats  # (2,)


@dataclass(frozen=True, eq=False)
class Bracket(Value):
    """Bounds on the survival time that a team can guarantee, whatever its strategy.

    Attributes
    ----------
    lower : float
        Guaranteed by `plan`, or by `contingent` with delays: the larger of both.
    lower_by : LowerEnd
        Which of both it is.
    upper : float
        No strategy guarantees more, even if the team sees the pursuer: a pursuer that announces
        `sequence`, or its first capture alone, has captured everybody by this time.
    upper_by : UpperEndKind
        What the pursuer announces, and whether the end needs the turn limits.
    plan : Plan
        The open-loop plan.
    contingent : ContingentPlan or None
        The plan that answers captures; None if none were to be answered.
    sequence : tuple of int
        The capture sequence that is announced. Where the first capture alone is announced, the
        order of the others that counts most.
    start : numpy.ndarray
        (2,) the point of the disk from which that pursuer starts.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> found = covey.bracket(team, disk)
    >>> found.sequence
    (1, 0, 2)
    >>> print(found.lower_by)
    contingent plan
    """

    lower: float
    lower_by: LowerEnd
    upper: float
    upper_by: UpperEndKind
    plan: Plan
    contingent: ContingentPlan | None
    sequence: tuple[int, ...]
    start: Floats

    def __repr__(self) -> str:
        """Return both bounds, and what they are due to, in one line."""
        second = self.plan.team.units.time
        return one_line(
            "Bracket",
            lower=quantity(self.lower, second),
            lower_by=self.lower_by,
            upper=quantity(self.upper, second),
            upper_by=self.upper_by,
            sequence=self.sequence,
        )

    def _repr_html_(self) -> str:
        second = self.plan.team.units.time
        facts = {
            titled("lower", second): self.lower,
            "lower by": self.lower_by,
            titled("upper", second): self.upper,
            "upper by": self.upper_by,
            "sequence": self.sequence,
        }
        return html_row("Bracket", facts)


def bracket(
    team: Team,
    disk: PursuerDisk,
    *,
    depth: int | None = None,
    seed: int = 0,
    starts: int | None = None,
) -> Bracket:
    """Bracket the true value of the game from below and above.

    Parameters
    ----------
    team, disk
        The state of the game; up to 50 evaders, each slower than the pursuer.
    depth
        How many captures the contingent plan answers, see `covey.plan_contingent`; 0: there is no
        such plan. None: as many as take about a second, which is all for up to five evaders, two
        for six and seven, one for eight and nine, and none for more.
    seed, starts
        Of the search for the open-loop plan, see `covey.plan`; the seed also of the contingent one.

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
    The lower end is the better guarantee of the two plans. That of the contingent plan counts with
    delays, up to the resolution of their search (docs/decisions/0015).

    The upper end is the earliest of three. Two are upper bounds of the fixed-sequence value, the
    least over the sequences that a search visits: a pursuer that keeps to a sequence, and flies to
    each evader with the line of sight at a constant bearing, captures the last one no later,
    whatever the evaders do. The first end takes all evaders to turn at once (docs/decisions/0006).
    The second one knows their turn rates (docs/decisions/0017): its pursuer begins with a straight
    flight while the evaders still turn. The third pursuer announces its first capture alone, and
    then goes on in the best order; the evaders are taken to turn at once (docs/decisions/0018).

    The fixed-sequence value is a maximum over headings. Each call proves that no higher maximum was
    missed: the bound is computed at the corners of polygons that contain all that the evaders can
    reach. For evaders that turn at once it exceeded the maximum found by less than 1e-11, relative,
    in 700 random games of three and five evaders.

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

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> found = covey.bracket(team, disk)
    >>> print(f"{found.lower:.3f} to {found.upper:.3f}")
    3.378 to 3.382
    """
    found = plan(team, disk, seed=seed, starts=starts)
    depth = default_depth(len(team)) if depth is None else depth
    tree = plan_contingent(team, disk, depth, seed=seed) if depth != 0 else None
    lower, lower_by = found.survival_time, LowerEnd.OPEN_LOOP
    if tree is not None and tree.with_delays.survival_time > lower:
        lower, lower_by = tree.with_delays.survival_time, LowerEnd.CONTINGENT
    end = upper_bound(team, disk, found.critical_sequences[:2])
    return Bracket(
        lower=lower,
        lower_by=lower_by,
        upper=end.time,
        upper_by=end.by,
        plan=found,
        contingent=tree,
        sequence=end.sequence,
        start=end.start,
    )


def upper_bound(team: Team, disk: PursuerDisk, known: Iterable[tuple[int, ...]] = ()) -> UpperBound:
    """Return the earliest of the three upper ends; the search also compares `known` sequences."""
    center = disk.center
    team, disk = about_center(team, disk)
    end = earliest_end(team, disk, known=known)
    start = PursuerDisk(end.start, 0.0, disk.speed, disk.capture_radius)
    by_next = next_capture_bound(team, start, end.time)
    place = read_only(center + end.start)
    if by_next is not None:
        order = by_next.orders[int(by_next.weights.argmax())]
        sequence = (by_next.first, *order)
        return UpperBound(by_next.time, UpperEndKind.NEXT_CAPTURE, sequence, place)
    by = UpperEndKind.TURN_LIMITS if end.needs_limits else UpperEndKind.AGILE
    return UpperBound(end.time, by, end.sequence, place)


def default_depth(n: int) -> int:
    """Return how many captures are answered by default."""
    return n - 1 if n <= 5 else _DEPTHS.get(n, 0)
