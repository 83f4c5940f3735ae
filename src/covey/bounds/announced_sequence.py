"""The capture sequence that a pursuer should announce if it has to keep to it."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from covey.bounds.fixed_sequence import SequencePlan, plan_for_sequence
from covey.kernels.bounds.fixed_sequence import first_captures, lay_grid, new_grid, next_captures
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.planning.border import pursuit_of

_GRID_HEADINGS = 25
"""Headings of each evader on the grid on which sequences are compared."""

_BEAM_WIDTH = 64
"""Prefixes that the beam search extends at a time; up to five evaders these are all prefixes."""

_FINALISTS = 4
"""Sequences, the best on the grid, that are compared exactly."""


class _Prefix(NamedTuple):
    """The first captures of a sequence."""

    sequence: tuple[int, ...]
    latest: Floats  # (headings,) latest time of the last of them, by the heading of its evader


def best_announcement(
    team: Team, disk: PursuerDisk, known: Iterable[tuple[int, ...]]
) -> SequencePlan:
    """Return the first of `announcements`: the best sequence found, and the team's answer."""
    return announcements(team, disk, known)[0]


def announcements(
    team: Team, disk: PursuerDisk, known: Iterable[tuple[int, ...]]
) -> list[SequencePlan]:
    """Find sequences with an early last capture, although the team knows the sequence.

    A beam search on a grid of headings picks the finalists. They and the `known` sequences are
    compared exactly. The first need not be the best of all sequences: the value of every sequence
    is an upper bound of the game's value.

    Parameters
    ----------
    team, disk
        The state of the game, each evader slower than the pursuer.
    known
        Sequences that are compared with those that the search finds.

    Returns
    -------
    list of SequencePlan
        The sequences with the team's best answers to them, the earliest last capture first.
    """
    values = sequences_on_grid(team, disk)
    finalists = sorted(values, key=lambda sequence: values[sequence])[:_FINALISTS]
    plans = [plan_for_sequence(team, disk, sequence) for sequence in {*finalists, *known}]
    return sorted(plans, key=lambda plan: (plan.survival_time, plan.sequence))


def sequences_on_grid(team: Team, disk: PursuerDisk) -> dict[tuple[int, ...], float]:
    """Return sequences and the latest times of their last captures on the grid."""
    n, pursuit = len(team), pursuit_of(disk)
    grid = new_grid(team.as_rows(), _GRID_HEADINGS)
    lay_grid(grid, np.zeros(n), math.pi, disk.speed)
    unused = np.empty(_GRID_HEADINGS, np.int64)

    def first(i: int) -> _Prefix:
        latest = np.empty(_GRID_HEADINGS)
        first_captures(grid.paths, pursuit, i, latest)
        return _Prefix((i,), latest)

    def extend(prefix: _Prefix, i: int) -> _Prefix:
        latest = np.empty(_GRID_HEADINGS)
        next_captures(grid.paths, pursuit, prefix.sequence[-1], i, prefix.latest, latest, unused)
        return _Prefix((*prefix.sequence, i), latest)

    beam = [first(i) for i in range(n)]
    for _ in range(1, n):
        families = [
            [extend(prefix, i) for i in range(n) if i not in prefix.sequence] for prefix in beam
        ]
        # Each evader left is captured at the earliest as the next one, so no sequence of a family
        # ends before the family's latest next capture.
        families.sort(key=lambda family: max(float(each.latest.max()) for each in family))
        beam = _undominated(each for family in families[:_BEAM_WIDTH] for each in family)
    return {each.sequence: float(each.latest.max()) for each in beam}


def _undominated(prefixes: Iterable[_Prefix]) -> list[_Prefix]:
    """Drop each prefix that ends no earlier than another, whatever the last evader's heading.

    Prefixes are compared if they capture the same evaders and the same one last.
    """
    kept: dict[tuple[frozenset[int], int], list[_Prefix]] = {}
    for new in prefixes:
        rivals = kept.setdefault((frozenset(new.sequence), new.sequence[-1]), [])
        if not any((rival.latest <= new.latest).all() for rival in rivals):
            rivals[:] = [rival for rival in rivals if (rival.latest < new.latest).any()]
            rivals.append(new)
    return [each for rivals in kept.values() for each in rivals]
