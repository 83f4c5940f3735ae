"""Pursuers that follow a capture sequence (section V.B of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.kernels.ascent import ascent_scratch
from covey.kernels.path import PATH, set_paths
from covey.kernels.replanning import commit
from covey.model import InputError
from covey.model.checks import Ints, number
from covey.planning.guarantee import pursuit_of
from covey.simulation import Chase, PursuerPolicy, Situation


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
    """

    margin: float = 0.01

    def __post_init__(self) -> None:
        """Check the field."""
        if self.margin != math.inf:
            number("CommittedPursuer.margin", self.margin, low=0.0)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "committed", "margin": self.margin}

    def commitment(self, n: int) -> tuple[float, Ints, bool]:
        """Return margin, sequence and whether it is known, for a compiled game of n evaders."""
        return self.margin, np.empty(n, np.int64), False

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return _Committed(self.margin, ())


@dataclass(frozen=True)
class FixedSequence:
    """Capture the evaders in a given order, whatever they do.

    Parameters
    ----------
    sequence
        Each evader's number once.
    """

    sequence: tuple[int, ...]

    def __init__(self, sequence: Sequence[int]) -> None:
        order = tuple(int(i) for i in sequence)
        if sorted(order) != list(range(len(order))):
            raise InputError(
                f"FixedSequence: expected each evader 0..N-1 once, got {list(sequence)}"
            )
        object.__setattr__(self, "sequence", order)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "fixed-sequence", "sequence": list(self.sequence)}

    def commitment(self, n: int) -> tuple[float, Ints, bool]:
        """Return margin, sequence and whether it is known, for a compiled game of n evaders."""
        self._require(n)
        return math.inf, np.array(self.sequence, dtype=np.int64), True

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        committed = _Committed(math.inf, self.sequence)
        begun = False

        def decide(situation: Situation) -> Chase:
            nonlocal begun
            if not begun:
                self._require(len(situation.evaders))
                begun = True
            return committed(situation)

        return decide

    def _require(self, n: int) -> None:
        if len(self.sequence) != n:
            raise InputError(
                f"FixedSequence: expected a sequence of all {n} evaders, got {list(self.sequence)}"
            )


class _Committed:
    """The sequence that a pursuer follows, by evader number; empty while it has none."""

    def __init__(self, margin: float, sequence: tuple[int, ...]) -> None:
        self._margin, self._sequence = margin, sequence

    def __call__(self, situation: Situation) -> Chase:
        n, living = len(situation.evaders), situation.evaders
        followed = [living.index(i) for i in self._sequence if i in living]
        sequence = np.array(followed if followed else [0] * n, dtype=np.int64)
        paths = np.empty((n, PATH))
        disk = situation.disk
        set_paths(situation.team.as_rows(), situation.turns, disk.speed, paths)
        commit(
            paths,
            n,
            pursuit_of(disk),
            self._margin,
            bool(followed),
            sequence,
            np.empty(n),
            ascent_scratch(n),
        )
        self._sequence = tuple(living[row] for row in sequence)
        return Chase(self._sequence)
