"""A proven bound on how late the last capture in a known sequence can come.

The evaders' velocities lie in disks. The maximum over all flights, curved, slow and wavering ones
included, is at most the maximum over the corners of polygons around these disks
(docs/decisions/0006). The bound is tight because the corners are dense around the best headings
known, and then around the headings at which the bound is attained.
"""

from __future__ import annotations

import itertools
import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from covey.bounds.fixed_sequence import SequencePlan
from covey.kernels.maximum.fixed_sequence import first_captures, next_captures
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors, wrap_angle
from covey.model.validation import Floats, read_only
from covey.planning.guarantee import longest_game, paths_of, pursuit_of


class Spacing(NamedTuple):
    """How dense the corners of the polygons are."""

    closest: (
        float  # radians from the best heading to the next tangent; the bound errs by its square
    )
    growth: float  # gap to the next tangent, as a share of the distance from the best heading


DENSE = Spacing(1e-6, 0.12)
"""The bound exceeds the maximum by less than 1e-11, relative."""

SPARSE = Spacing(1e-5, 0.4)
"""By less than 1e-9, in a tenth of the interceptions."""

_LARGEST_GAP = 0.3
_MAX_TANGENTS = 4000
_MAX_CENTERS = 5
_FULL_TURN = 2.0 * math.pi


def last_capture_bound(team: Team, disk: PursuerDisk, plan: SequencePlan) -> float:
    """Bound the last capture in a known sequence from above, whatever the evaders do.

    Parameters
    ----------
    team, disk
        The state of the game, each evader slower than the pursuer. The pursuer starts at the disk's
        centre. It flies to each evader's exact position; only for the last one the capture radius
        counts. An evader that it passes on the way counts as still flying.
    plan
        The sequence, and headings near which the maximum is expected.

    Returns
    -------
    float
        A time by which the last evader is captured.
    """
    return bound_near(team, disk, plan.sequence, plan.goal_headings, DENSE)[0]


def bound_near(
    team: Team, disk: PursuerDisk, sequence: tuple[int, ...], headings: Floats, spacing: Spacing
) -> tuple[float, Floats]:
    """Return the bound for a sequence, and headings (N,) near which the maximum is.

    As `last_capture_bound`; it is expected near `headings` (N,). The corners have the `spacing`.
    """
    right = _tangents(float(team.speeds.max()) / disk.speed, spacing)
    if len(right) == 0:
        return longest_game(team, disk), headings
    bound, centers = math.inf, headings[np.newaxis, :]
    for _ in range(_MAX_CENTERS):
        corners, stretch = _corners(right, centers)
        latest, attained = _latest_at_corners(team, disk, sequence, corners, stretch)
        bound = min(bound, latest)
        off = np.abs(wrap_angle(centers - attained)).min(axis=0)
        if off[list(sequence[:-1])].max(initial=0.0) < spacing.closest:
            break
        centers = np.vstack([centers, attained])
    return bound, attained


def _latest_at_corners(
    team: Team, disk: PursuerDisk, sequence: tuple[int, ...], headings: Floats, stretch: Floats
) -> tuple[float, Floats]:
    """Return the latest last capture over all corners, and the headings (N,) that attain it.

    Corner velocities have the directions `headings` (N, corners) and are `stretch` (N, corners)
    times as fast as the evader. The last evader's heading is not searched for: its first corner's
    stands there.
    """
    *others, last = sequence
    attained = headings[:, 0].copy()
    times, positions = np.zeros(1), disk.center[np.newaxis, :]
    predecessor = np.empty(headings.shape, np.int64)
    if others:
        corners = headings.shape[1]
        evader = np.repeat(np.arange(len(team)), corners)
        speeds = team.speeds[evader] * stretch.ravel()
        to_corners = Team(team.positions[evader], headings.ravel(), speeds, math.inf)
        paths = paths_of(to_corners, disk, np.zeros(len(to_corners)))
        pursuit, times = pursuit_of(PursuerDisk(disk.center, 0.0, disk.speed)), np.empty(corners)
        first_captures(paths, pursuit, others[0], times)
        for previous, i in itertools.pairwise(others):
            earlier, times = times, np.empty(corners)
            next_captures(paths, pursuit, previous, i, earlier, times, predecessor[i])
        before_last = to_corners.take(np.flatnonzero(evader == others[-1]))
        flown = (before_last.speeds * times)[:, np.newaxis] * unit_vectors(before_last.headings)
        positions = before_last.positions + flown
    # The last evader flees straight from the capture before its own, at its own speed.
    gaps = np.hypot(*(team.positions[last] - positions).T) - disk.capture_radius
    fled = (disk.speed * times + gaps) / (disk.speed - team.speeds[last])
    ends = np.maximum(fled, times)
    corner = int(ends.argmax())
    latest = float(ends[corner])
    for i in reversed(others):
        attained[i], corner = headings[i, corner], predecessor[i, corner]
    return latest, attained


@lru_cache(maxsize=64)
def _tangents(ratio: float, spacing: Spacing) -> Floats:
    """Return angles in (0, π] from a polygon's densest direction to its tangents of the unit disk.

    The gaps are so small that an evader of `ratio` times the pursuer's speed stays slower than the
    pursuer at every corner. Empty if that takes more than `_MAX_TANGENTS`.
    """
    gap = min(_LARGEST_GAP, 2.0 * math.acos(2.0 * ratio / (1.0 + ratio)))
    if gap * _MAX_TANGENTS < 2.0 * math.pi:
        return np.empty(0)
    tangents = [spacing.closest]
    while tangents[-1] < math.pi:
        tangents.append(tangents[-1] + min(spacing.growth * tangents[-1], gap))
    return read_only(np.array([*tangents[:-1], math.pi]))


def _corners(right: Floats, centers: Floats) -> tuple[Floats, Floats]:
    """Return directions and distances (N, corners) of the corners of polygons around unit disks.

    The polygons touch the disks in the directions `right` (T,) to both sides of all `centers`
    (C, N).
    """
    offsets = np.concatenate([-right[:-1], right])
    touching = np.sort(
        (centers.T[:, :, np.newaxis] + offsets).reshape(len(centers.T), -1) % _FULL_TURN
    )
    around = np.hstack([touching, touching[:, :1] + _FULL_TURN])
    return 0.5 * (around[:, 1:] + around[:, :-1]), 1.0 / np.cos(0.5 * np.diff(around))
