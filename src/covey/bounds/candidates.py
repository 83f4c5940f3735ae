"""Capture sequences that a pursuer may announce, compared again and again as a game goes on."""

from __future__ import annotations

import itertools
import math

import numpy as np

from covey.bounds.announced_sequence import sequences_on_grid
from covey.bounds.polygon_bound import SPARSE, Opening, bound_near
from covey.kernels.bounds.announced_sequences import FLIGHT, raise_lower_bounds
from covey.model import PursuerDisk, Team
from covey.planning.border import pursuit_of

_ALL_UP_TO = 6
"""Evaders up to which all sequences are candidates; of more, those that a beam search finds."""


def candidate_sequences(team: Team, disk: PursuerDisk) -> tuple[tuple[int, ...], ...]:
    """Return the sequences that are compared; turn rates don't matter."""
    n = len(team)
    if n <= _ALL_UP_TO:
        return tuple(itertools.permutations(range(n)))
    agile = Team(team.positions, team.headings, team.speeds, math.inf)
    return tuple(sequences_on_grid(agile, disk))


class Candidates:
    """Sequences for the evaders of a game, and headings near the team's best answer to each.

    Parameters
    ----------
    team, disk
        The state of the game; the pursuer is at the disk's centre. Turn rates don't matter.

    Attributes
    ----------
    sequences : tuple of tuple of int
    """

    def __init__(self, team: Team, disk: PursuerDisk) -> None:
        n = len(team)
        self.sequences = candidate_sequences(team, disk)
        self._orders = np.array(self.sequences, dtype=np.int64)
        away = np.arctan2(*(team.positions - disk.center).T[::-1])
        self._headings = np.tile(away, (len(self.sequences), 1))
        self._lower = np.empty(len(self.sequences))
        self._flights = np.empty((n, FLIGHT))

    def better_than(self, cutoff: float, team: Team, disk: PursuerDisk) -> dict[int, float]:
        """Return proven bounds for the sequences that may be better than the cutoff.

        By number of the sequence; the bound may be above the cutoff. A lower bound excludes all
        others, and those that are above a bound that is proven already.
        """
        pursuit = pursuit_of(PursuerDisk(disk.center, 0.0, disk.speed, disk.capture_radius))
        team = Team(team.positions, team.headings, team.speeds, math.inf)
        evaders = team.as_rows()
        raise_lower_bounds(
            evaders, pursuit, cutoff, self._orders, self._headings, self._lower, self._flights
        )
        proven: dict[int, float] = {}
        below = np.flatnonzero(self._lower < cutoff)
        for row in below[self._lower[below].argsort(kind="stable")].tolist():
            if self._lower[row] > min(proven.values(), default=cutoff):
                break
            proven[row] = self._bound(row, team, disk)
        return proven

    def _bound(self, row: int, team: Team, disk: PursuerDisk) -> float:
        """Return the proven bound of a sequence, and keep the headings that attain it."""
        sequence, headings = self.sequences[row], self._headings[row]
        opening = Opening(0.0, disk.center)
        bound, self._headings[row] = bound_near(team, disk, sequence, headings, SPARSE, opening)
        return bound
