"""Pursuers that follow the best capture sequence of the moment (section V.B of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from covey.kernels.play.commitment import Commitment
from covey.model import InputError, PursuerDisk, Team
from covey.model.validation import Floats, frozen_array, number
from covey.players.pursuers.commitment import CommittingPursuer
from covey.simulation import PursuerPolicy


@dataclass(frozen=True)
class CommittedPursuer(CommittingPursuer):
    """At every update, follow the sequence that captures the announced plans earliest.

    The paper's pursuer of section V.B, with commitment. The team's plan makes several sequences
    equally good, and a pursuer that chose among them anew at every update would go nowhere. This
    pursuer keeps its sequence unless another is better by a margin.

    Parameters
    ----------
    margin
        Gain for which the pursuer takes another sequence, >= 0, relative to the time that its
        sequence still takes. `inf` keeps the first sequence for ever, 0 changes for any gain.

    Notes
    -----
    Where a game is about the sum of survival times, sequences are compared by that sum.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, pursuer=covey.CommittedPursuer(margin=0.05))
    >>> game.survival_time >= game.guarantee
    True
    """

    margin: float = 0.01

    def __post_init__(self) -> None:
        """Check the field."""
        _check_margin("CommittedPursuer", self.margin)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "committed", "margin": self.margin}

    def commitment(self, team: Team, disk: PursuerDisk, seed: int) -> Commitment:  # noqa: ARG002
        """Return the commitment to whichever sequence is best first."""
        return Commitment(self.margin, np.empty(len(team), np.int64), False)


@dataclass(frozen=True)
class UncommittedPursuer(CommittedPursuer):
    """At every update, follow the best sequence of that moment, however little better it is.

    `CommittedPursuer` with a margin of 0; scenario files call it "patient". The team's plan makes
    several sequences equally good, and whichever is followed is worse at the next update. So this
    pursuer dithers, and may never capture anybody (docs/decisions/0005).

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, pursuer=covey.UncommittedPursuer(), update_time=0.1)
    >>> game.survival_time >= game.guarantee
    True
    """

    margin: float = field(default=0.0, init=False, repr=False)

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "patient"}


@dataclass(frozen=True)
class FlyingPursuer:
    """A committed pursuer that has a position in the disk, and flies, hidden or not.

    The rules know any other hidden pursuer as a disk only. Such a disk changes its target at no
    cost and captures from whichever of its points is best: the team must reckon with that. This
    pursuer has a position, and a team that can't see the pursuer knows only the disk. The pursuer
    plans from its position, loses time by each change of target, and captures every evader that
    comes within ρ.

    Parameters
    ----------
    margin
        As for `CommittedPursuer`.
    offset
        (2,) from the disk's centre to the position at time 0, in radii of the disk, at most 1 long.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk(radius=0.1, capture_radius=0.02)
    >>> pursuer = covey.FlyingPursuer(offset=(1.0, 0.0))  # from the right edge of the disk
    >>> game = covey.simulate(team, disk, pursuer=pursuer, update_time=0.05)
    >>> game.pursuer_positions[0].tolist()
    [0.1, 0.0]
    """

    margin: float = 0.01
    offset: tuple[float, float] = (0.0, 0.0)

    def __init__(self, margin: float = 0.01, offset: Sequence[float] = (0.0, 0.0)) -> None:
        _check_margin("FlyingPursuer", margin)
        x, y = frozen_array("FlyingPursuer.offset", offset, (2,)).tolist()
        if math.hypot(x, y) > 1.0 + 1e-12:
            raise InputError(
                f"FlyingPursuer.offset: expected a point at most 1 from the origin, got {[x, y]}"
            )
        object.__setattr__(self, "margin", margin)
        object.__setattr__(self, "offset", (x, y))

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "flying", "margin": self.margin, "offset": list(self.offset)}

    def place(self, disk: PursuerDisk) -> Floats:
        """Return the position (2,) at time 0."""
        position: Floats = disk.center + disk.radius * np.array(self.offset)
        return position

    def start(self, seed: int) -> PursuerPolicy:
        """Return the policy of one game."""
        return CommittedPursuer(self.margin).start(seed)


def _check_margin(name: str, margin: float) -> None:
    if margin != math.inf:
        number(f"{name}.margin", margin, low=0.0)
