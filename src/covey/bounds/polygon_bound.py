"""A proven bound on how late the last capture in a known sequence can come.

The maximum over all headings, and over all curved, slow or wavering flights too, is at most that
over the corners of polygons which contain the disks of the evaders' velocities
(docs/decisions/0006). The corners stand close around the best headings known, and then around those
that the bound itself points at, so that it is close as well.
"""

from __future__ import annotations

import itertools
import math

import numpy as np

from covey.bounds.fixed_sequence import SequencePlan
from covey.kernels.maximum.fixed_sequence import first_captures, next_captures
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors, wrap_angle
from covey.model.validation import Floats
from covey.planning.guarantee import longest_game, paths_of, pursuit_of

_CLOSEST = 1e-6
"""Radians from the best heading to the next tangent; the bound errs by the square of it."""

_GROWTH = 0.12
"""By how much of its distance from the best heading a tangent is farther away than the last."""

_LARGEST_GAP = 0.3
_MOST_TANGENTS = 4000
_MOST_CENTERS = 5
_FULL_TURN = 2.0 * math.pi


def latest_capture(team: Team, disk: PursuerDisk, plan: SequencePlan) -> float:
    """Bound the last capture in the plan's sequence, whatever the evaders do.

    The pursuer starts at the disk's centre and comes to the evaders' very places, except the last
    one, which it captures from as far as it can reach. A captured evader counts as if it flew on.
    """
    right = _tangents(float(team.speeds.max()) / disk.speed)
    if len(right) == 0:
        return longest_game(team, disk)
    bound, centers = math.inf, plan.goal_headings[np.newaxis, :]
    for _ in range(_MOST_CENTERS):
        headings, stretch = _corners(right, centers)
        latest, where = _latest_at_corners(team, disk, plan.sequence, headings, stretch)
        bound = min(bound, latest)
        off = np.abs(wrap_angle(centers - where)).min(axis=0)
        if off[list(plan.sequence[:-1])].max(initial=0.0) < _CLOSEST:
            break
        centers = np.vstack([centers, where])
    return bound


def _latest_at_corners(
    team: Team, disk: PursuerDisk, sequence: tuple[int, ...], headings: Floats, stretch: Floats
) -> tuple[float, Floats]:
    """Return the latest last capture and the headings (N,) of all but the last that it belongs to.

    `headings` (N, corners) are those of the corners, `stretch` how much faster they are.
    """
    *others, last = sequence
    best = headings[:, 0].copy()
    times, places = np.zeros(1), disk.center[np.newaxis, :]
    before = np.empty(headings.shape, np.int64)
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
            next_captures(paths, pursuit, previous, i, earlier, times, before[i])
        before_last = to_corners.take(np.flatnonzero(evader == others[-1]))
        flown = (before_last.speeds * times)[:, np.newaxis] * unit_vectors(before_last.headings)
        places = before_last.positions + flown
    # The last one flees straight from where the one before is captured, at its own speed.
    gaps = np.hypot(*(team.positions[last] - places).T) - disk.capture_radius
    fled = (disk.speed * times + gaps) / (disk.speed - team.speeds[last])
    ends = np.maximum(fled, times)
    corner = int(ends.argmax())
    latest = float(ends[corner])
    for i in reversed(others):
        best[i], corner = headings[i, corner], before[i, corner]
    return latest, best


def _tangents(ratio: float) -> Floats:
    """Directions up to π, from a heading in the middle, in which a polygon touches the unit disk.

    Evaders of `ratio` times the pursuer's speed, stretched to its corners, must stay slower; there
    are none if that takes too many.
    """
    gap = min(_LARGEST_GAP, 2.0 * math.acos(2.0 * ratio / (1.0 + ratio)))
    if gap * _MOST_TANGENTS < 2.0 * math.pi:
        return np.empty(0)
    tangents = [_CLOSEST]
    while tangents[-1] < math.pi:
        tangents.append(tangents[-1] + min(_GROWTH * tangents[-1], gap))
    return np.array([*tangents[:-1], math.pi])


def _corners(right: Floats, centers: Floats) -> tuple[Floats, Floats]:
    """Directions and distances (N, corners) of the corners of polygons around unit disks.

    They touch the disks in the directions of all tangents to both sides of all centers (C, N).
    """
    offsets = np.concatenate([-right[:-1], right])
    touching = np.sort(
        (centers.T[:, :, np.newaxis] + offsets).reshape(len(centers.T), -1) % _FULL_TURN
    )
    around = np.hstack([touching, touching[:, :1] + _FULL_TURN])
    return 0.5 * (around[:, 1:] + around[:, :-1]), 1.0 / np.cos(0.5 * np.diff(around))
