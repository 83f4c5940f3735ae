"""How a pursuer follows a capture sequence, and when it takes another."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod

import numpy as np

from covey.kernels.arrays import Workspace
from covey.kernels.play.commitment import Commitment, commit
from covey.model import PursuerDisk, Team
from covey.model.validation import Ints
from covey.planning.border import paths_of, pursuit_of
from covey.planning.long_calls import interceptions_of_minimum, interruptible
from covey.simulation import Chase, PursuerPolicy, Situation


class CommittingPursuer(ABC):
    """A pursuer that follows sequences; its games can be played compiled."""

    @abstractmethod
    def commitment(self, team: Team, disk: PursuerDisk, seed: int) -> Commitment:
        """Return the commitment with which it begins a game."""

    def start(self, seed: int) -> PursuerPolicy:
        """Return the policy of one game."""
        return SequenceFollower(self, seed)


class FixedOrderPursuer(CommittingPursuer):
    """A pursuer that chooses a sequence at the start of a game and keeps to it."""

    @abstractmethod
    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:
        """Return the order (N,) in which it captures this team."""

    def commitment(self, team: Team, disk: PursuerDisk, seed: int) -> Commitment:
        """Return the commitment to the sequence for this team."""
        return Commitment(math.inf, self.sequence_for(team, disk, seed), True)


class SequenceFollower:
    """The policy of a `CommittingPursuer` in one game."""

    in_any_frame = True

    def __init__(self, pursuer: CommittingPursuer, seed: int) -> None:
        self._pursuer, self._seed = pursuer, seed
        self._margin: float | None = None  # until the first decision
        self._sequence: tuple[int, ...] = ()  # by evader number; empty if none is chosen yet

    def __call__(self, situation: Situation) -> Chase:
        """Follow the sequence, or one that is better by the margin."""
        if self._margin is None:
            self._margin = self._begin(situation)
        n, living = len(situation.evaders), situation.evaders
        followed = [living.index(i) for i in self._sequence if i in living]
        sequence = np.array(followed if followed else [0] * n, dtype=np.int64)
        disk, total = situation.pursuer, situation.objective.measure == "total"
        paths = paths_of(situation.team, disk, situation.turns)
        commitment = Commitment(self._margin, sequence, bool(followed))

        def choose(scratch: Workspace) -> None:
            commit(paths, pursuit_of(disk), total, commitment, scratch)

        interruptible(choose, n, total, interceptions_of_minimum(n, total))
        self._sequence = tuple(living[row] for row in sequence)
        return Chase(self._sequence)

    def _begin(self, situation: Situation) -> float:
        commitment = self._pursuer.commitment(situation.team, situation.pursuer, self._seed)
        if commitment.is_chosen:
            self._sequence = tuple(situation.evaders[row] for row in commitment.sequence)
        return commitment.margin
