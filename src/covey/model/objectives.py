"""Objectives: what the team maximises and the pursuer minimises."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from covey.model.units import counted
from covey.model.validation import (
    Floats,
    InputError,
    Ints,
    choice,
    listed,
    number,
    permutation,
    shown,
)

MEASURES = ("last", "total")

MAX_PERMUTED = 8
"""Largest team for which an expectation runs over all N! sequences; 40 320 for this one."""


class SequenceDistribution(NamedTuple):
    """Capture sequences and their probabilities."""

    sequences: Ints  # (K, N)
    probabilities: Floats  # (K,)


@dataclass(frozen=True)
class LastCapture:
    """The time of the last capture, guaranteed against any pursuer: the paper's objective.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> plan = covey.plan(team, disk, objective=covey.LastCapture())
    >>> plan.value == plan.survival_time
    True
    """

    measure: ClassVar[str] = "last"

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "last-capture"}


@dataclass(frozen=True)
class TotalSurvival:
    """The sum of all survival times, guaranteed against any pursuer.

    The first of the two objectives that the paper's last sentence proposes.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> plan = covey.plan(team, disk, objective=covey.TotalSurvival())
    >>> round(plan.value, 3), round(plan.survival_time, 3)
    (5.414, 3.18)
    """

    measure: ClassVar[str] = "total"

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "total-survival"}


@dataclass(frozen=True)
class ExpectedSurvival:
    """The expected value for a pursuer that draws its capture sequence; nothing is guaranteed.

    The second objective that the paper's last sentence proposes. Each capture rules out the
    sequences that don't begin with the captures so far.

    Parameters
    ----------
    sequences
        Capture sequences that the pursuer draws from, each with every evader's number once. None:
        all sequences, for teams of up to eight.
    weights
        Relative probability of each sequence, >= 0. None: all sequences are equally likely.
    measure
        Whose value is expected: "total", the sum of all survival times, or "last", the time of the
        last capture.

    Raises
    ------
    InputError
        If an argument can't be used.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> sequences, weights = [(0, 1, 2), (0, 2, 1)], [3.0, 1.0]
    >>> likely = covey.ExpectedSurvival(sequences, weights, measure="last")
    >>> round(covey.plan(team, disk, objective=likely).value, 3)
    3.583
    """

    sequences: tuple[tuple[int, ...], ...] | None = None
    weights: tuple[float, ...] | None = None
    measure: str = "total"

    def __init__(
        self,
        sequences: Sequence[Sequence[int]] | None = None,
        weights: Sequence[float] | None = None,
        measure: str = "total",
    ) -> None:
        kept = checked_distribution("ExpectedSurvival", sequences, weights)
        for name, value in zip(("sequences", "weights"), kept, strict=True):
            object.__setattr__(self, name, value)
        object.__setattr__(self, "measure", choice("ExpectedSurvival.measure", measure, MEASURES))

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        return {
            "name": "expected-survival",
            **describe_distribution(self.sequences, self.weights),
            "measure": self.measure,
        }


Objective = LastCapture | TotalSurvival | ExpectedSurvival

OBJECTIVES: Mapping[str, Callable[..., Objective]] = {
    "last-capture": LastCapture,
    "total-survival": TotalSurvival,
    "expected-survival": ExpectedSurvival,
}
"""The objectives, by the names that scenario files know."""


def objective_value(objective: Objective, capture_times: npt.ArrayLike) -> float:
    """Return the sum or the latest of a whole team's capture times (N,), as the objective asks."""
    times = np.asarray(capture_times, dtype=np.float64)
    return float(times.sum() if objective.measure == "total" else times.max())


def distribution_of(
    name: str,
    sequences: tuple[tuple[int, ...], ...] | None,
    weights: tuple[float, ...] | None,
    count: int,
) -> SequenceDistribution:
    """Return the distribution of the capture sequences of `count` evaders.

    Raises
    ------
    InputError
        If the sequences are of another team, or too many. `name` begins the message.
    """
    if sequences is None:
        if count > MAX_PERMUTED:
            raise InputError(
                f"{name}: all sequences of {count} evaders are too many, {MAX_PERMUTED} evaders "
                "at most; give the sequences that matter"
            )
        sequences = tuple(itertools.permutations(range(count)))
    if len(sequences[0]) != count:
        raise InputError(
            f"{name}: expected sequences of all {counted(count, 'evader')}, "
            f"got {shown(list(sequences[0]))}"
        )
    shares = np.ones(len(sequences)) if weights is None else np.array(weights)
    return SequenceDistribution(np.array(sequences, dtype=np.int64), shares / shares.sum())


def checked_distribution(
    name: str, sequences: Sequence[Sequence[int]] | None, weights: Sequence[float] | None
) -> tuple[tuple[tuple[int, ...], ...] | None, tuple[float, ...] | None]:
    """Return sequences of one team and their weights, checked; else raise InputError."""
    if sequences is None:
        if weights is not None:
            raise InputError(
                f"{name}.weights: expected none without sequences, got {shown(weights)}"
            )
        return None, None
    given = listed(f"{name}.sequences", sequences)
    count = len(listed(f"{name}.sequences", given[0])) if given else 0
    if count == 0:
        raise InputError(f"{name}.sequences: expected at least one, got {shown(given)}")
    kept = tuple(
        tuple(permutation(f"{name}.sequences", sequence, count).tolist()) for sequence in given
    )
    if len(set(kept)) < len(kept):
        raise InputError(f"{name}.sequences: expected each once, got one twice")
    return kept, None if weights is None else _checked_weights(name, weights, len(kept))


def _checked_weights(name: str, weights: Sequence[float], count: int) -> tuple[float, ...]:
    given = listed(f"{name}.weights", weights)
    kept = tuple(number(f"{name}.weights", weight, low=0.0) for weight in given)
    if len(kept) != count:
        raise InputError(
            f"{name}.weights: expected one for each of {count} sequences, got {len(kept)}"
        )
    if not 0.0 < sum(kept) < math.inf:
        raise InputError(f"{name}.weights: expected at least one > 0, got {shown(list(kept))}")
    return kept


def describe_distribution(
    sequences: tuple[tuple[int, ...], ...] | None, weights: tuple[float, ...] | None
) -> Mapping[str, Any]:
    """Return the sequences and weights that were given, as a scenario file gives them."""
    described: dict[str, Any] = {}
    if sequences is not None:
        described["sequences"] = [list(sequence) for sequence in sequences]
    if weights is not None:
        described["weights"] = list(weights)
    return described
