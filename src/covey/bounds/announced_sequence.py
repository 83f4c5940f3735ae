"""Which capture sequence a pursuer should announce if it has to keep to it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from covey.bounds.fixed_sequence import SequencePlan, plan_for_sequence
from covey.kernels.maximum.fixed_sequence import first_captures, lay_grid, new_grid, next_captures
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.planning.guarantee import pursuit_of

_HEADINGS = 25
"""Headings of each evader on the grid on which sequences are compared."""

_WIDTH = 64
"""Beginnings that are followed at a time: all that there are, up to five evaders."""

_FINALISTS = 4
"""Sequences, the best on the grid, that are compared exactly."""


class _Beginning(NamedTuple):
    """The first captures of a sequence, and the latest time of the last of them by its heading."""

    sequence: tuple[int, ...]
    latest: Floats  # (headings,)


def best_announcement(
    team: Team, disk: PursuerDisk, known: Iterable[tuple[int, ...]]
) -> SequencePlan:
    """Find a capture sequence with an early last capture although the team knows it.

    A beam search over the beginnings of sequences. Every sequence serves as a bound, so it needs no
    proof that it is the best; the `known` ones compete.
    """
    values = _search(team, disk)
    finalists = sorted(values, key=lambda sequence: values[sequence])[:_FINALISTS]
    plans = [plan_for_sequence(team, disk, sequence) for sequence in {*finalists, *known}]
    return min(plans, key=lambda plan: (plan.survival_time, plan.sequence))


def _search(team: Team, disk: PursuerDisk) -> dict[tuple[int, ...], float]:
    """Return sequences and when they end, on the grid."""
    n, pursuit = len(team), pursuit_of(disk)
    grid = new_grid(team.as_rows(), _HEADINGS)
    lay_grid(grid, np.zeros(n), math.pi, disk.speed)
    before = np.empty(_HEADINGS, np.int64)

    def begin(i: int) -> _Beginning:
        latest = np.empty(_HEADINGS)
        first_captures(grid.paths, pursuit, i, latest)
        return _Beginning((i,), latest)

    def extend(start: _Beginning, i: int) -> _Beginning:
        latest = np.empty(_HEADINGS)
        next_captures(grid.paths, pursuit, start.sequence[-1], i, start.latest, latest, before)
        return _Beginning((*start.sequence, i), latest)

    beam = [begin(i) for i in range(n)]
    for _ in range(1, n):
        families = [
            [extend(start, i) for i in range(n) if i not in start.sequence] for start in beam
        ]
        # Whoever is left can at best be the next one, so no sequence of a family ends earlier.
        families.sort(key=lambda family: max(float(each.latest.max()) for each in family))
        beam = _undominated(each for family in families[:_WIDTH] for each in family)
    return {each.sequence: float(each.latest.max()) for each in beam}


def _undominated(beginnings: Iterable[_Beginning]) -> list[_Beginning]:
    """Drop those that come later, whatever the last heading, than another of the same captures."""
    kept: dict[tuple[frozenset[int], int], list[_Beginning]] = {}
    for new in beginnings:
        rivals = kept.setdefault((frozenset(new.sequence), new.sequence[-1]), [])
        if not any((rival.latest <= new.latest).all() for rival in rivals):
            rivals[:] = [rival for rival in rivals if (rival.latest < new.latest).any()]
            rivals.append(new)
    return [each for rivals in kept.values() for each in rivals]
