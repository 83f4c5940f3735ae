"""A proven bound on how late the last capture in a known sequence can come.

What each evader can reach is bounded by polygons. The maximum over all flights, curved, slow and
wavering ones included, is at most the maximum over the flights of the polygons' corners
(docs/decisions/0006 for evaders that turn at once, 0017 for limited turn rates). The bound is tight
because the corners are dense around the best headings known, and then around the headings at which
the bound is attained.
"""

from __future__ import annotations

import itertools
import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from covey.bounds.fixed_sequence import SequencePlan
from covey.bounds.reachable_hull import Corners, corners_of
from covey.kernels.bounds.fixed_sequence import first_captures, next_captures
from covey.kernels.capture.path import sample
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors, wrap_angle
from covey.model.validation import Floats, read_only
from covey.planning.border import longest_game, paths_of, pursuit_of


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


class Opening(NamedTuple):
    """A straight flight with which the pursuer begins, whatever the evaders do."""

    time: float
    end: Floats  # (2,) where the pursuer is at that time


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
    opening = Opening(0.0, disk.center)
    return bound_near(team, disk, plan.sequence, plan.goal_headings, DENSE, opening)[0]


def first_capture(team: Team, disk: PursuerDisk, plan: SequencePlan) -> Floats:
    """Return where (2,) the first capture of a plan happens."""
    place = np.empty((1, 1, 2))
    first = plan.sequence[0]
    path = paths_of(team, disk, plan.turns)[first : first + 1]
    sample(path, plan.capture_times[:1], place)
    first_place: Floats = place[0, 0]
    return first_place


def opening_towards(team: Team, disk: PursuerDisk, plan: SequencePlan, time: float) -> Opening:
    """Return the opening of a pursuer that flies towards the first capture of a plan."""
    way = first_capture(team, disk, plan) - disk.center
    length = float(np.hypot(*way))
    share = disk.speed * time / length if length > 0.0 else 0.0
    return Opening(time, disk.center + share * way)


def bound_near(
    team: Team,
    disk: PursuerDisk,
    sequence: tuple[int, ...],
    headings: Floats,
    spacing: Spacing,
    opening: Opening,
) -> tuple[float, Floats]:
    """Return the bound for a sequence, and headings (N,) near which the maximum is.

    As `last_capture_bound`; it is expected near `headings` (N,). The corners have the `spacing`.
    After its `opening` the pursuer flies to each evader with the line of sight at a constant
    bearing.
    """
    right = _tangents(float(team.speeds.max()) / disk.speed, spacing)
    if len(right) == 0:
        return longest_game(team, disk), headings
    known = turn_limits_known(team, disk, sequence, opening)
    bound, centers = math.inf, headings[np.newaxis, :]
    for _ in range(_MAX_CENTERS):
        corners = corners_of(team, _touching(right, centers), known, opening.time)
        latest, attained = _latest_at_corners(team, disk, sequence, corners, known, opening)
        bound = min(bound, latest)
        off = np.abs(wrap_angle(centers - attained)).min(axis=0)
        if off.max() < spacing.closest:
            break
        centers = np.vstack([centers, attained])
    return bound, attained


def turn_limits_known(
    team: Team, disk: PursuerDisk, sequence: tuple[int, ...], opening: Opening
) -> Floats:
    """Return the times (N,) before which no evader can be the pursuer's target.

    Until then the turn limit of an evader counts. A capture at T of evader i, from x_i, has
    |x_i - p| <= v_i T + v_p (T - t) if the pursuer was at p at the time t.
    """
    known, time = np.full(len(team), opening.time), opening.time
    meeting = disk.speed + team.speeds
    to_opening = np.hypot(*(team.positions - opening.end).T) + disk.speed * opening.time
    for previous, i in itertools.pairwise(sequence):
        known[i] = time = max(time, to_opening[previous] / meeting[previous])
        gap = float(np.hypot(*(team.positions[i] - team.positions[previous])))
        time = max(time, (gap + (disk.speed - team.speeds[previous]) * time) / meeting[i])
    return np.where(np.isinf(team.turn_rates), opening.time, known)


def _latest_at_corners(
    team: Team,
    disk: PursuerDisk,
    sequence: tuple[int, ...],
    corners: Corners,
    known: Floats,
    opening: Opening,
) -> tuple[float, Floats]:
    """Return the latest last capture over all corners, and the headings (N,) that attain it."""
    *others, last = sequence
    attained = np.empty(len(team))
    count = corners.headings.shape[1]
    times, positions = np.zeros(1), opening.end[np.newaxis, :]
    predecessor = np.empty(corners.headings.shape, np.int64)
    if others:
        flights = Team(
            corners.positions.reshape(-1, 2),
            corners.headings.ravel(),
            corners.speeds.ravel(),
            math.inf,
        )
        point = PursuerDisk(opening.end, 0.0, disk.speed)
        paths, pursuit = paths_of(flights, point, np.zeros(len(flights))), pursuit_of(point)
        times = np.empty(count)
        first_captures(paths, pursuit, others[0], times)
        for previous, i in itertools.pairwise(others):
            earlier, times = times, np.empty(count)
            next_captures(paths, pursuit, previous, i, earlier, times, predecessor[i])
        positions = _after(corners, others[-1], times)
    # The last evader is taken to turn at once from the time on at which it becomes the target.
    places = _distinct(_after(corners, last, np.full(count, known[last] - opening.time)))
    away = places[np.newaxis] - positions[:, np.newaxis]
    distances = np.hypot(away[..., 0], away[..., 1])
    farthest = distances.argmax(axis=1)
    gaps = distances.max(axis=1) - disk.capture_radius
    fled = gaps + team.speeds[last] * (times + opening.time - known[last])
    ends = times + np.maximum(fled / (disk.speed - team.speeds[last]), 0.0)
    corner = int(ends.argmax())
    latest = float(ends[corner])
    x, y = away[corner, farthest[corner]]
    attained[last] = math.atan2(y, x)
    for i in reversed(others):
        attained[i], corner = corners.headings[i, corner], predecessor[i, corner]
    return opening.time + latest, attained


def _after(corners: Corners, i: int, times: Floats) -> Floats:
    """Return the positions (C, 2) of evader i's corners after `times` (C,)."""
    flown = (corners.speeds[i] * times)[:, np.newaxis] * unit_vectors(corners.headings[i])
    after: Floats = corners.positions[i] + flown
    return after


def _distinct(points: Floats) -> Floats:
    """Return points (C, 2) without repetition, in ascending order.

    Complex numbers and not rows: `np.unique` of rows answers an interrupt by a TypeError, because
    NumPy replaces the exception while it looks for a common type.
    """
    return np.unique(points.view(np.complex128)).view(np.float64).reshape(-1, 2)


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


def _touching(right: Floats, centers: Floats) -> list[Floats]:
    """Return for each evader the directions, rising within a full turn, of its tangents.

    They are `right` (T,) to both sides of all `centers` (C, N).
    """
    offsets = np.concatenate([-right[:-1], right])
    around = centers.T[:, :, np.newaxis] + offsets
    return list(np.sort(around.reshape(len(around), -1) % _FULL_TURN))
