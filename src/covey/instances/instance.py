"""A game of the set, and what is known about it."""

from __future__ import annotations

from dataclasses import dataclass

from covey.bounds.bracket import LowerEnd, UpperEndKind
from covey.model import PursuerDisk, Team
from covey.model.display import one_line
from covey.model.validation import Floats
from covey.model.value import Value


@dataclass(frozen=True, eq=False)
class KnownPlan(Value):
    """The best plan known for a game.

    Attributes
    ----------
    turns : numpy.ndarray
        (N,) signed turns δ in [-π, π], radians: turn by δ at full rate, then fly straight.
    goal_headings : numpy.ndarray
        (N,) headings φ after the turn, radians in [-π, π].
    survival_time : float
        Guaranteed by this plan against any pursuer in the disk.
    worst_sequence : tuple of int
        The capture sequence that ends this plan earliest, of all that are known.
    upper : float
        The least time in which that sequence captures everybody.

    Examples
    --------
    >>> import covey
    >>> game = covey.load_instance("circle-6")
    >>> times = covey.capture_times(
    ...     game.team, game.disk, game.plan.turns, game.plan.worst_sequence
    ... )
    >>> bool(abs(times[-1] - game.plan.upper) < 1e-9)
    True
    """

    turns: Floats
    goal_headings: Floats
    survival_time: float
    worst_sequence: tuple[int, ...]
    upper: float

    @property
    def exact(self) -> bool:
        """Whether `survival_time` is the exact minimum over all capture sequences."""
        return self.survival_time == self.upper


@dataclass(frozen=True, eq=False)
class KnownBracket(Value):
    """What is known about the true value of a game, see `covey.Bracket`.

    Attributes
    ----------
    lower : float
        A team is sure of this survival time.
    lower_by : LowerEnd
        What guarantees it: the plan, or a contingent plan.
    depth : int
        How many captures the contingent plan answers; 0 where the plan guarantees `lower`.
    upper : float
        No team is sure of more.
    upper_by : UpperEndKind
        How the pursuer is sure of that.
    sequence : tuple of int
        What this pursuer announces.
    start : numpy.ndarray
        (2,) where this pursuer starts.

    Examples
    --------
    >>> import covey
    >>> bracket = covey.load_instance("paper-5").bracket
    >>> bracket.lower <= bracket.upper
    True
    """

    lower: float
    lower_by: LowerEnd
    depth: int
    upper: float
    upper_by: UpperEndKind
    sequence: tuple[int, ...]
    start: Floats


@dataclass(frozen=True, eq=False)
class Instance(Value):
    """A game of the covey set, and what is known about it.

    Attributes
    ----------
    name : str
        As in `covey.load_instance`.
    team, disk : Team, PursuerDisk
        The state at time 0.
    plan : covey.instances.KnownPlan
        The best plan known, and what it guarantees.
    bracket : covey.instances.KnownBracket
        What is known about the true value of the game.

    Examples
    --------
    >>> import covey
    >>> game = covey.load_instance("paper-5")
    >>> len(game.team), game.plan.exact
    (5, True)
    >>> covey.plan(game.team, game.disk).survival_time <= game.plan.survival_time + 1e-9
    True
    """

    name: str
    team: Team
    disk: PursuerDisk
    plan: KnownPlan
    bracket: KnownBracket

    def parts(self) -> tuple[Team, PursuerDisk, KnownPlan, KnownBracket]:
        """Return everything but the name."""
        return self.team, self.disk, self.plan, self.bracket

    def __repr__(self) -> str:
        """Return the name, the size, and what is known, in one line."""
        return one_line(
            "Instance",
            self.name,
            evaders=len(self.team),
            survival_time=self.plan.survival_time,
            exact=self.plan.exact,
            upper_bound=self.bracket.upper,
        )
