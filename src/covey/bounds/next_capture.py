"""A proven bound on the last capture if the pursuer announces its first capture alone.

After the first capture the pursuer goes on in the order that is best then. For evaders that turn at
once, a mean over the orders with fixed weights bounds what it reaches. The weights are the best
ones against the flights of the team that are known, and each search for the maximum of the mean
ends with a proof or with another flight (docs/decisions/0018).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from covey.bounds.candidates import candidate_sequences
from covey.bounds.matrix_game import best_weights
from covey.kernels.bounds.announced_sequences import FLIGHT
from covey.kernels.bounds.corner_programme import CORNER, STATE, CornerProgramme
from covey.kernels.bounds.mixture import Mixture, MixtureScratch, climb_mixture
from covey.kernels.bounds.mixture_bound import Branches, mixture_bound
from covey.kernels.capture.path import EVADER
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors
from covey.model.validation import Floats, Ints, read_only
from covey.planning.border import pursuit_of

_MOST_EVADERS = 7
"""Larger teams take many seconds, and gain little by one capture that is left open."""

_SLACK = 3e-3
"""By how much the bound may exceed the value of the best weights, relative."""

_FINEST = 0.1
"""Radians; a corner that stands for so much to both sides overstates the speed by 0.5 %."""

_MOST_STEPS = 300_000
"""Steps of dynamic programmes in all searches, a third of them in one search."""

_GAIN = 1e-3
"""Relative gain of the value by another flight, below which a coarser proof is tried."""

_KEPT = 4
"""Flights, the worst ones for the weights, from which a climb begins."""

_CLOSEST, _GROWTH, _LARGEST = 0.04, 0.8, 0.6
"""Radians to the first tangent, the gap to the next one as a share of it, and at most."""

_MOST_TANGENTS = 100

_SAME = math.cos(1e-2)
"""Flights whose headings differ by less than 1e-2 radians count as the same."""

_NO_WEIGHT = 1e-6

_NEARLY = 0.98
"""Share of the largest mean from which on a flight may be near a maximum."""


class NextCapture(NamedTuple):
    """What a pursuer that announces its first capture alone can be sure of."""

    time: float  # by which everybody is captured
    first: int  # the evader that it announces
    orders: tuple[tuple[int, ...], ...]  # it goes on in one of these, the best one then
    weights: Floats  # (m,) of the orders in the proof


def next_capture_bound(team: Team, disk: PursuerDisk, below: float) -> NextCapture | None:
    """Bound the last capture from above for a pursuer that announces one capture at a time.

    Parameters
    ----------
    team, disk
        The state of the game, each evader slower than the pursuer; turn rates don't matter, for
        all evaders are taken to turn at once. The pursuer starts at the disk's centre. It flies to
        each evader's exact position; only for the last one the capture radius counts.
    below
        Time that is known to be a bound.

    Returns
    -------
    NextCapture or None
        None where no bound below the known one was found, or proven, and for teams of more than
        seven.
    """
    corners = _corners(float(team.speeds.max()) / disk.speed)
    if not 3 <= len(team) <= _MOST_EVADERS or len(corners) == 0:
        return None
    sequences = candidate_sequences(team, disk)
    firsts = [_First(team, disk, i, sequences, corners) for i in range(len(team))]
    worth = below / (1.0 + _SLACK)
    for first in firsts:
        first.improve(worth)
        worth = min(worth, first.value)
    rough, left = 1.0, _MOST_STEPS
    while left > 0:
        best = min(firsts, key=lambda first: first.value)
        value, target = best.value, best.value * (1.0 + rough * _SLACK)
        if target >= below:
            break
        bound, attained, steps = best.bound(target, min(rough, 2.0) * _FINEST)
        if bound <= target:
            return best.as_result(bound)
        left -= steps
        if best.add(attained):
            best.improve(below)
        if best.value < value * (1.0 + _GAIN):
            rough *= 1.5
    return None


class _Flight(NamedTuple):
    """A flight of the team until the first capture, and what follows."""

    headings: Floats  # (N,) radians
    values: Floats  # (m,) last captures, by order
    gradients: Floats  # (m, N, 2) of these, by the evaders' positions at the first capture


class _First:
    """An evader that is captured first, and the orders of those left.

    `value` is the least over the weights of the largest mean over the flights that are known.
    """

    def __init__(
        self,
        team: Team,
        disk: PursuerDisk,
        first: int,
        sequences: tuple[tuple[int, ...], ...],
        corners: Floats,
    ) -> None:
        left = [i for i in range(len(team)) if i != first]
        self._numbers = np.array([first, *left])
        rest = sorted({tuple(i for i in each if i != first) for each in sequences})
        self._orders = 1 + np.searchsorted(left, np.array(rest))
        self._evaders = team.as_rows()[self._numbers]
        self._pursuit = pursuit_of(PursuerDisk(disk.center, 0.0, disk.speed, disk.capture_radius))
        self._corners = corners
        self._ratio = float(team.speeds.max()) / disk.speed
        self._scratch = _new_scratch(len(team), len(rest), corners)
        self._weights = np.full(len(rest), 1.0 / len(rest))
        away = self._evaders[:, :2] - disk.center
        self._away = np.arctan2(away[:, 1], away[:, 0])
        self._flights: list[_Flight] = []
        self.value = 0.0
        self.add(self._away)

    def add(self, headings: Floats) -> bool:
        """Climb from these headings; return whether that led to a flight that was not known."""
        headings = headings.copy()
        values = np.empty(len(self._orders))
        climb_mixture(self._mixture(), headings, values, self._scratch)
        near = [np.cos(headings - flight.headings).min() for flight in self._flights]
        if max(near, default=-1.0) > _SAME:
            return False
        self._flights.append(_Flight(headings, values, self._scratch.gradients.copy()))
        table = np.array([flight.values for flight in self._flights])
        self._weights, self.value = best_weights(table)
        return True

    def improve(self, enough: float) -> None:
        """Climb from the flights that are worst for the weights, until that finds no other.

        Or until the value is `enough`.
        """
        while self.value < enough:
            worst = sorted(self._flights, key=lambda flight: -float(self._weights @ flight.values))
            new = [self.add(flight.headings) for flight in worst[:_KEPT]]
            if not any(new):
                break

    def bound(self, target: float, finest: float) -> tuple[float, Floats, int]:
        """Return a bound of the mean if it is at most the target; corners are as fine as `finest`.

        Else a time above the target, and headings (N,) at which the mean may exceed it. Returns
        also how many steps of dynamic programmes that took.
        """
        used = np.flatnonzero(self._weights > _NO_WEIGHT)
        weights = self._weights[used] / self._weights[used].sum()
        sequence = self._by_disagreement(used, weights)
        place = sequence.argsort()
        mixture = Mixture(
            self._evaders[sequence], self._pursuit, place[self._orders[used]], weights
        )
        scratch = _new_scratch(len(sequence), len(used), self._corners)
        steps = len(used) * (len(sequence) - 2)  # of a branch
        headings = self._away[sequence]
        branches = _new_branches(len(sequence), len(used), self._ratio)
        branches = branches._replace(finest=finest, most=_MOST_STEPS // (3 * steps))
        bound, bounded = mixture_bound(mixture, target, branches, headings, scratch)
        return bound, headings[place], (1 + bounded) * steps

    def _by_disagreement(self, used: Ints, weights: Floats) -> Ints:
        """Return the evaders (N,), the first one and then those that the orders pull apart most.

        The orders' bounds are attained at the same headings where the orders agree, so a search
        that fixes the others early is short.
        """
        means = [float(self._weights @ flight.values) for flight in self._flights]
        apart = np.zeros(len(self._evaders))
        for flight, mean in zip(self._flights, means, strict=True):
            if mean > _NEARLY * max(means):
                gradients = flight.gradients[used]
                off = gradients - np.einsum("s,snd->nd", weights, gradients)
                apart = np.maximum(apart, weights @ np.hypot(off[..., 0], off[..., 1]))
        apart[0] = math.inf
        return (-apart).argsort(kind="stable")

    def _mixture(self) -> Mixture:
        return Mixture(self._evaders, self._pursuit, self._orders, self._weights)

    def as_result(self, bound: float) -> NextCapture:
        """Return the bound, in the team's numbers."""
        used = np.flatnonzero(self._weights > _NO_WEIGHT)
        orders = self._numbers[self._orders[used]].tolist()
        weights = self._weights[used] / self._weights[used].sum()
        first = int(self._numbers[0])
        return NextCapture(bound, first, tuple(map(tuple, orders)), read_only(weights))


def _new_scratch(n: int, orders: int, corners: Floats) -> MixtureScratch:
    """Allocate the scratch of a mixture."""
    return MixtureScratch(
        np.zeros(n),
        np.ones(n),
        np.zeros((n, EVADER)),
        np.zeros(n),
        np.zeros((n, EVADER)),
        np.zeros((orders, n)),
        np.zeros((n, FLIGHT)),
        np.zeros((orders, n, 2)),
        CornerProgramme(
            corners,
            np.zeros((n, len(corners), STATE)),
            np.zeros((n, len(corners)), np.int64),
            np.zeros(n),
        ),
    )


def _new_branches(n: int, orders: int, ratio: float) -> Branches:
    """Allocate a search. Corners of its first polygon are slower than the pursuer."""
    corners = math.ceil(math.pi / min(math.pi / 8, math.acos(2.0 * ratio / (1.0 + ratio))))
    stack = n * (corners + 8)
    return Branches(
        corners,
        _FINEST,
        0,
        np.zeros(stack, np.int64),
        np.zeros((stack, n)),
        np.zeros((stack, n)),
        np.zeros((stack, orders, n)),
    )


@lru_cache(maxsize=64)
def _corners(ratio: float) -> Floats:
    """Return the corners (C, CORNER) of a polygon around a unit disk, dense around one direction.

    The gaps are so small that an evader of `ratio` times the pursuer's speed stays slower than the
    pursuer at every corner. Empty if that takes too many.
    """
    gap = min(_LARGEST, 2.0 * math.acos(2.0 * ratio / (1.0 + ratio)))
    if gap * _MOST_TANGENTS < 2.0 * math.pi:
        return np.empty((0, CORNER))
    right = [_CLOSEST]
    while right[-1] < math.pi:
        right.append(right[-1] + min(_GROWTH * max(right[-1], 2.5 * _CLOSEST), gap))
    right[-1] = math.pi
    left = [-each for each in reversed(right)]
    touching = np.array([*left, *right])
    middle, gaps = 0.5 * (touching[1:] + touching[:-1]), np.diff(touching)
    directions = unit_vectors(middle)
    return read_only(np.column_stack([directions, 1.0 / np.cos(0.5 * gaps)]))
