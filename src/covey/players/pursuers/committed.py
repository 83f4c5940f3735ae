"""Pursuers that follow the best capture sequence of the moment (section V.B of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.model import InputError, PursuerDisk, Team
from covey.model.validation import Floats, frozen_array, number
from covey.players.pursuers.commitment import Commitment, Committed
from covey.simulation import PursuerPolicy


@dataclass(frozen=True)
class CommittedPursuer:
    """At every update, follow the sequence that captures the announced plans earliest.

    The paper's pursuer of section V.B, with commitment: the team's plan makes several sequences
    equally good, and a pursuer that chose among them anew at every update would go nowhere. It
    keeps its sequence unless another is better by a margin.

    Parameters
    ----------
    margin
        Relative to the time that the sequence it follows still takes, >= 0; `inf` keeps the first
        sequence for ever, 0 changes for any gain.

    Notes
    -----
    Where a game is about the sum of survival times, sequences are compared by that.
    """

    margin: float = 0.01

    def __post_init__(self) -> None:
        """Check the field."""
        _check_margin("CommittedPursuer", self.margin)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "committed", "margin": self.margin}

    def commitment(self, team: Team, disk: PursuerDisk, seed: int) -> Commitment:  # noqa: ARG002
        """Return what a compiled game needs to know."""
        return Commitment(self.margin, np.empty(len(team), np.int64), False)

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return Committed(self.margin, ())


@dataclass(frozen=True)
class PatientPursuer:
    """At every update, follow the best sequence of that moment, however little better it is.

    It is patient with itself: the team's plan makes several sequences equally good, and whichever
    is followed is worse at the next update, so it dithers and may never be done
    (docs/decisions/0005). `CommittedPursuer` with a margin of 0.
    """

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "patient"}

    def commitment(self, team: Team, disk: PursuerDisk, seed: int) -> Commitment:
        """Return what a compiled game needs to know."""
        return CommittedPursuer(0.0).commitment(team, disk, seed)

    def start(self, seed: int) -> PursuerPolicy:
        """Return the policy of one game."""
        return CommittedPursuer(0.0).start(seed)


@dataclass(frozen=True)
class FlyingPursuer:
    """A committed pursuer that really is somewhere in the disk, and flies, hidden or not.

    The rules know a hidden pursuer as a disk only, which may change its mind for nothing and
    captures from wherever in it suits best: what the team must reckon with. This one has a place,
    of which a team that can't see it knows the disk alone. It plans from there, pays for each
    change of mind, and captures whomever it comes within ρ of.

    Parameters
    ----------
    margin
        As for `CommittedPursuer`.
    offset
        (2,) where it is at time 0: from the disk's centre, in radii of the disk, at most 1 long.
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
        """Return where in the disk it is at time 0."""
        place: Floats = disk.center + disk.radius * np.array(self.offset)
        return place

    def start(self, seed: int) -> PursuerPolicy:
        """Return the policy of one game."""
        return CommittedPursuer(self.margin).start(seed)


def _check_margin(name: str, margin: float) -> None:
    if margin != math.inf:
        number(f"{name}.margin", margin, low=0.0)
