"""Pursuers that fix the order of capture at the start of a game, and keep to it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.model import InputError, PursuerDisk, Team
from covey.model.checks import Ints
from covey.players.commitment import KeepsSequence


@dataclass(frozen=True)
class FixedSequence(KeepsSequence):
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

    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:  # noqa: ARG002
        """Return the sequence given, if it fits the team."""
        if len(self.sequence) != len(team):
            raise InputError(
                f"FixedSequence: expected a sequence of all {len(team)} evaders, "
                f"got {list(self.sequence)}"
            )
        return np.array(self.sequence, dtype=np.int64)


@dataclass(frozen=True)
class RandomSequence(KeepsSequence):
    """Capture the evaders in an order that is drawn from the game's seed, whatever they do."""

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "random-sequence"}

    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:  # noqa: ARG002
        """Return the order that was drawn."""
        # Not the stream that the starts of the searches come from.
        generator = np.random.default_rng([seed, 1])
        return generator.permutation(len(team))
