"""Pursuers that fix the order of capture at the start of a game, and keep to it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.bounds.announced_sequence import best_announcement
from covey.model import PursuerDisk, Team
from covey.model.objectives import checked_distribution, describe_distribution, distribution_of
from covey.model.validation import Ints, checked_sequence, require_whole_team
from covey.players.pursuers.commitment import FixedOrderPursuer


@dataclass(frozen=True)
class FixedSequence(FixedOrderPursuer):
    """Capture the evaders in a given order, whatever they do.

    Parameters
    ----------
    sequence
        Each evader's number once. None: 0, 1, 2 and so on, which fits teams of every size.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, pursuer=covey.FixedSequence([2, 0, 1]))
    >>> game.capture_sequence.tolist()
    [2, 0, 1]
    """

    sequence: tuple[int, ...] | None = None

    def __init__(self, sequence: Sequence[int] | None = None) -> None:
        if sequence is not None:
            sequence = checked_sequence("FixedSequence", sequence)
        object.__setattr__(self, "sequence", sequence)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        given = {} if self.sequence is None else {"sequence": list(self.sequence)}
        return {"name": "fixed-sequence", **given}

    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:  # noqa: ARG002
        """Return the sequence given, if it is one of this team."""
        if self.sequence is None:
            return np.arange(len(team))
        require_whole_team("FixedSequence", self.sequence, len(team))
        return np.array(self.sequence, dtype=np.int64)


@dataclass(frozen=True)
class BestSequence(FixedOrderPursuer):
    """Capture the evaders in the order with the best guaranteed capture time, whatever they do.

    A team that knows the sequence has a longest survival time for it. The pursuer takes the
    sequence for which this time is least, as in the references (the paper's [7] and [8]). A team
    that turns at once can't survive longer, whatever it does. A team with limited turn rates may
    prolong the game a little, by turns that it announces and doesn't fly.

    Notes
    -----
    The sequences are compared on a grid of headings, and the best few exactly. Up to five evaders,
    all sequences are compared; with more, those that a beam search finds.

    References
    ----------
    See `KnownSequence`, the team that flies against it.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, pursuer=covey.BestSequence())
    >>> game.capture_sequence.tolist()
    [1, 0, 2]
    """

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "best-sequence"}

    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:  # noqa: ARG002
        """Return the order that a team which knows the order could delay least."""
        return np.array(best_announcement(team, disk, ()).sequence, dtype=np.int64)


@dataclass(frozen=True)
class RandomSequence(FixedOrderPursuer):
    """Capture the evaders in an order that is drawn from the game's seed, whatever they do.

    Parameters
    ----------
    sequences
        Sequences to draw from, each with every evader's number once. None: all sequences.
    weights
        Probability of each sequence, relative to the others, >= 0. None: all are equally likely.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> pursuer = covey.RandomSequence([(0, 1, 2), (2, 1, 0)], weights=[3.0, 1.0])
    >>> game = covey.simulate(team, disk, pursuer=pursuer, seed=4)
    >>> game.capture_sequence.tolist()
    [2, 1, 0]
    """

    sequences: tuple[tuple[int, ...], ...] | None = None
    weights: tuple[float, ...] | None = None

    def __init__(
        self,
        sequences: Sequence[Sequence[int]] | None = None,
        weights: Sequence[float] | None = None,
    ) -> None:
        kept = checked_distribution("RandomSequence", sequences, weights)
        for name, value in zip(("sequences", "weights"), kept, strict=True):
            object.__setattr__(self, name, value)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {"name": "random-sequence", **describe_distribution(self.sequences, self.weights)}

    def sequence_for(self, team: Team, disk: PursuerDisk, seed: int) -> Ints:  # noqa: ARG002
        """Return the order that the seed draws."""
        # The searches for plans take their random numbers from another stream.
        generator = np.random.default_rng([seed, 1])
        if self.sequences is None:
            return generator.permutation(len(team))
        draws = distribution_of("RandomSequence", self.sequences, self.weights, len(team))
        drawn: Ints = generator.choice(draws.sequences, p=draws.probabilities)
        return drawn
