"""A proven bound on how late the last capture in a known sequence can come.

The maximum over all headings, and over all curved, slow or wavering flights too, is at most that
over the corners of polygons which contain the disks of the evaders' velocities
(docs/decisions/0006). Around the best headings known the corners stand close, so that the bound is
close as well.
"""

from __future__ import annotations

import itertools
import math

import numpy as np

from covey.kernels.fixed_sequence import first_captures, next_captures
from covey.kernels.path import HEADING, PATH, SPEED, TURN_RATE, set_paths
from covey.model import PursuerDisk, Team
from covey.model.checks import Floats
from covey.planning.fixed_sequence import SequencePlan
from covey.planning.guarantee import longest_game, pursuit_of

_CLOSEST = 1e-6
"""Radians from the best heading to the next tangent; the bound errs by the square of it."""

_GROWTH = 0.12
"""By how much of its distance from the best heading a tangent is farther away than the last."""

_LARGEST_GAP = 0.3
_MOST_TANGENTS = 4000


def latest_capture(team: Team, disk: PursuerDisk, plan: SequencePlan) -> float:
    """Bound the last capture in the plan's sequence, whatever the evaders do.

    The pursuer starts at the disk's centre and comes to the evaders' very places, except the last
    one, which it captures from as far as it can reach. A captured evader counts as if it flew on.
    """
    *others, last = plan.sequence
    pursuit = pursuit_of(PursuerDisk(disk.center, 0.0, disk.speed))
    times, places = np.zeros(1), disk.center[np.newaxis, :]
    if others:
        offsets, stretch = _corners(float(team.speeds.max()) / disk.speed)
        if len(offsets) == 0:
            return longest_game(team, disk)
        rows = np.repeat(team.as_rows(), len(offsets), axis=0)
        rows[:, HEADING] = (plan.goal_headings[:, np.newaxis] + offsets).ravel()
        rows[:, SPEED] *= np.tile(stretch, len(team))
        rows[:, TURN_RATE] = math.inf
        paths = np.empty((len(rows), PATH))
        set_paths(rows, np.zeros(len(rows)), disk.speed, paths)
        times, before = np.empty(len(offsets)), np.empty(len(offsets), np.int64)
        first_captures(paths, pursuit, others[0], times)
        for previous, i in itertools.pairwise(others):
            earlier, times = times, np.empty(len(offsets))
            next_captures(paths, pursuit, previous, i, earlier, times, before)
        corners = rows[others[-1] * len(offsets) :][: len(offsets)]
        flown = corners[:, SPEED] * times
        places = corners[:, :2] + flown[:, np.newaxis] * _units(corners[:, HEADING])
    # The last one flees straight from where the one before is captured, at its own speed.
    gaps = np.hypot(*(team.positions[last] - places).T) - disk.capture_radius
    fled = (disk.speed * times + gaps) / (disk.speed - team.speeds[last])
    return float(np.maximum(fled, times).max())


def _corners(ratio: float) -> tuple[Floats, Floats]:
    """Directions, relative to the best heading, and distances of the corners of a polygon.

    It contains the unit disk. Stretched so far, evaders of `ratio` times the pursuer's speed must
    stay slower than it; there are no corners if that takes too many.
    """
    gap = min(_LARGEST_GAP, 2.0 * math.acos(2.0 * ratio / (1.0 + ratio)))
    if gap * _MOST_TANGENTS < 2.0 * math.pi:
        return np.empty(0), np.empty(0)
    tangents = [_CLOSEST]
    while tangents[-1] < math.pi:
        tangents.append(tangents[-1] + min(_GROWTH * tangents[-1], gap))
    right = np.array(tangents[:-1])
    around = np.concatenate([-right[::-1], right, [math.pi, 2.0 * math.pi - right[-1]]])
    return 0.5 * (around[1:] + around[:-1]), 1.0 / np.cos(0.5 * np.diff(around))


def _units(angles: Floats) -> Floats:
    return np.column_stack([np.cos(angles), np.sin(angles)])
