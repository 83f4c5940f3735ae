"""How a pursuer follows a capture sequence, and when it changes its mind."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from typing import NamedTuple

import numpy as np

from covey.kernels.maximum.sqp import ascent_scratch
from covey.kernels.play.replanning import commit
from covey.model import PursuerDisk, Team
from covey.model.validation import Ints
from covey.planning.guarantee import paths_of, pursuit_of
from covey.simulation import Chase, PursuerPolicy, Situation


class Commitment(NamedTuple):
    """What a compiled game needs to know of a pursuer that follows sequences."""

    margin: float  # by which another must be better; inf keeps the sequence for ever
    sequence: Ints  # (N,)
    known: bool  # whether it begins with this sequence, or with the best


class Committed:
    """The sequence that a pursuer follows, by evader number; empty while it has none."""

    def __init__(self, margin: float, sequence: tuple[int, ...]) -> None:
        self._margin, self._sequence = margin, sequence

    def __call__(self, situation: Situation) -> Chase:
        """Follow the sequence, or a clearly better one."""
        n, living = len(situation.evaders), situation.evaders
        followed = [living.index(i) for i in self._sequence if i in living]
        sequence = np.array(followed if followed else [0] * n, dtype=np.int64)
        disk, total = situation.pursuer, situation.objective.measure == "total"
        commit(
            paths_of(situation.team, disk, situation.turns),
            n,
            pursuit_of(disk),
            total,
            self._margin,
            bool(followed),
            sequence,
            np.empty(n),
            ascent_scratch(n, total),
        )
        self._sequence = tuple(living[row] for row in sequence)
        return Chase(self._sequence)


class KeepsSequence(ABC):
    """A pursuer that chooses a sequence at the start of a game and keeps to it."""

    @abstractmethod
    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:
        """Return the order (N,) in which it captures this team."""

    def commitment(self, team: Team, disk: PursuerDisk, seed: int) -> Commitment:
        """Return what a compiled game needs to know."""
        return Commitment(math.inf, self.sequence_for(team, disk, seed), True)

    def start(self, seed: int) -> PursuerPolicy:
        """Return the policy of one game."""
        committed: Committed | None = None

        def decide(situation: Situation) -> Chase:
            nonlocal committed
            if committed is None:
                rows = self.sequence_for(situation.team, situation.pursuer, seed)
                order = tuple(situation.evaders[row] for row in rows)
                committed = Committed(math.inf, order)
            return committed(situation)

        return decide
