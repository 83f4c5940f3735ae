"""The protocol of strategies.

A strategy is a value. At the start of a game its `start(seed)` returns the policy of that game: a
function that is called at every decision. A plain function that needs no memory is a strategy too.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Protocol, TypeVar

import numpy as np
import numpy.typing as npt

from covey.model import InputError, LastCapture, Objective, PursuerDisk, Team
from covey.model.display import one_line, quantity
from covey.model.validation import Floats, frozen_array, shown
from covey.model.value import Value


@dataclass(frozen=True, eq=False)
class Situation(Value):
    """What a player knows when it decides.

    Attributes
    ----------
    time : float
        Time since the start of the game.
    evaders : tuple of int
        Numbers of the n evaders alive; all arrays here are in this order.
    team : Team
        The living, as they are now.
    disk : PursuerDisk
        Where the pursuer can be, by what the team knows. A visible pursuer is at the centre of a
        disk of radius 0; at time 0 the radius may be larger.
    turns : numpy.ndarray
        (n,) signed turns still to be flown of the plan announced last. For the team, this is the
        plan flown until now; for the pursuer, the plan just announced.
    objective : LastCapture or TotalSurvival or ExpectedSurvival
        What the game is about, in the numbers of the whole team.
    place : numpy.ndarray or None
        (2,) position of the pursuer. None for the team, and for a pursuer that is a disk only.
    until_update : float
        Time until the next update. A capture brings a decision before it.
    chooses_start : bool
        Whether the pursuer has still to choose where in the disk it starts; see `Fly.offset`.

    Examples
    --------
    >>> import math
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> def flee(situation):
    ...     # away from the centre of the disk
    ...     away = situation.team.positions - situation.disk.center
    ...     return covey.turns_to(situation.team, [math.atan2(y, x) for x, y in away])
    ...
    >>> game = covey.simulate(team, disk, evaders=flee, update_time=0.1)
    >>> round(game.survival_time, 2)
    3.09
    """

    time: float
    evaders: tuple[int, ...]
    team: Team
    disk: PursuerDisk
    turns: Floats
    objective: Objective = LastCapture()  # noqa: RUF009 frozen
    place: Floats | None = None
    until_update: float = math.inf
    chooses_start: bool = False

    def __repr__(self) -> str:
        """Return when it is, who is alive, and where the pursuer can be, in one line."""
        return one_line(
            "Situation",
            time=quantity(self.time, self.team.units.time),
            evaders=self.evaders,
            disk=self.disk,
        )

    @property
    def pursuer(self) -> PursuerDisk:
        """Where the pursuer can be, by what this player knows."""
        if self.place is None:
            return self.disk
        return replace(self.disk, center=self.place, radius=0.0)

    def moved(self, by: Floats) -> Situation:
        """Return the situation, moved `by` (2,)."""
        place = None if self.place is None else self.place + by
        return replace(self, team=self.team.moved(by), disk=self.disk.moved(by), place=place)


@dataclass(frozen=True)
class Chase:
    """Chase the evaders in this order; until the next decision, the first.

    Attributes
    ----------
    sequence : tuple of int
        Numbers of living evaders. The first is flown to; the others are for the record.
    assurance : float
        For the record: time since the start of the game by which this pursuer has captured
        everybody, whatever the evaders do. Default: it assures nothing.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> def downwards(situation):
    ...     # the lowest first
    ...     heights = situation.team.positions[:, 1]
    ...     return covey.Chase(tuple(situation.evaders[i] for i in heights.argsort()))
    ...
    >>> game = covey.simulate(team, disk, pursuer=downwards, update_time=0.1)
    >>> game.capture_sequence.tolist()
    [2, 0, 1]
    """

    sequence: tuple[int, ...]
    assurance: float = math.inf


@dataclass(frozen=True)
class Fly:
    """Fly this velocity. A pursuer that is a disk only, without a position, can only wait.

    Attributes
    ----------
    velocity : tuple of float
        (2,), not faster than the pursuer's speed. Default: it waits.
    sequence : tuple of int
        For the record: the order in which it means to capture the living. Default: it doesn't say.
    assurance : float
        For the record, as in `Chase`.
    offset : tuple of float
        (2,) from the disk's centre to where the pursuer starts, if it still has to choose that: a
        visible pursuer, at time 0 of a game that begins with a disk. Default: at the centre.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.0]], headings=[0.0])
    >>> disk = covey.PursuerDisk(capture_radius=0.05)
    >>> def to_the_right(situation):
    ...     # along the x axis at full speed
    ...     return covey.Fly(velocity=(1.0, 0.0))
    ...
    >>> game = covey.simulate(team, disk, pursuer=to_the_right, sensing="visible")
    >>> round(game.survival_time, 3)
    0.333
    """

    velocity: tuple[float, float] = (0.0, 0.0)
    sequence: tuple[int, ...] = ()
    assurance: float = math.inf
    offset: tuple[float, float] = (0.0, 0.0)


TeamPolicy = Callable[[Situation], npt.ArrayLike]
"""Returns (n,) signed turns in [-π, π] of the living."""

PursuerPolicy = Callable[[Situation], Chase | Fly]

Function = TypeVar("Function", bound=Callable[..., Any])
Policy = Callable[[Situation], Any]
"""Of either side, before its decisions are checked."""


class TeamStrategy(Protocol):
    """A strategy of the evaders."""

    def start(self, seed: int) -> TeamPolicy:
        """Return the policy of one game."""
        ...


class PursuerStrategy(Protocol):
    """A strategy of the pursuer.

    If the strategy also has a method `place(disk)`, the pursuer has a position. At time 0 this is
    the point (2,) that the method returns for the disk; from there it flies, hidden or not.
    """

    def start(self, seed: int) -> PursuerPolicy:
        """Return the policy of one game."""
        ...


def description(strategy: object) -> Mapping[str, Any]:
    """Return name and parameters of a strategy, for the record."""
    describe = getattr(strategy, "describe", None)
    if describe is not None:
        described: Mapping[str, Any] = describe()
        return described
    return {"name": getattr(strategy, "__name__", type(strategy).__name__)}


def position_of(strategy: object, disk: PursuerDisk) -> Floats | None:
    """Return the position of a pursuer at time 0, or None if its strategy gives none.

    Raises
    ------
    InputError
        If the position isn't in the disk.
    """
    choose = getattr(strategy, "place", None)
    if choose is None:
        return None
    position = frozen_array("place returned by the pursuer's strategy", choose(disk), (2,))
    distance = float(np.hypot(*(position - disk.center)))
    rounding = 1e-12 * (disk.radius + float(np.abs(disk.center).max()))
    if distance > disk.radius + rounding:
        raise InputError(
            f"place returned by the pursuer's strategy: expected a point of the disk of radius "
            f"{disk.radius:g}, got one {distance:g} from its centre"
        )
    return position


def policy_of(role: str, strategy: object, seed: int) -> Policy:
    """Return the policy that a strategy, or a plain function, follows in a game.

    Raises
    ------
    InputError
        If `strategy` is neither; `role` is the name of the argument that holds it.
    """
    start = getattr(strategy, "start", None)
    if isinstance(strategy, type):
        raise InputError(
            f"{role}: expected a strategy, got the class {strategy.__name__}; "
            f"make a value of it: {strategy.__name__}(...)"
        )
    if callable(start):
        policy: Policy = start(seed)
        return policy
    if callable(strategy):
        return strategy
    raise InputError(
        f"{role}: expected a strategy (a value with a method start(seed)) or a function of a "
        f"Situation, got {shown(strategy)}"
    )


def in_any_frame(policy: Function) -> Function:
    """Mark a policy whose decisions don't depend on the frame; see `in_own_frame`."""
    policy.in_any_frame = True  # type: ignore[attr-defined]
    return policy


def in_own_frame(policy: Policy, origin: Floats) -> Policy:
    """Return a policy that is called with situations of the game's own frame.

    The origin of that frame is `origin` (2,). A policy that is marked `in_any_frame` sees these
    situations as they are, so without rounding; others see them in the user's coordinates.
    """
    if getattr(policy, "in_any_frame", False) or not origin.any():
        return policy
    return lambda situation: policy(situation.moved(origin))
