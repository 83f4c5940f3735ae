"""Polygons around all places that a turn-limited evader can have reached.

Let d(θ, t) be the largest displacement within t in the direction that is θ off the heading. An
evader attains it by turning towards that direction at its full rate and then flying straight. The
convex hull of what it can reach is {x : n(α)·(x - x₀) <= d(α - heading, t) for all α}.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.model import Team
from covey.model.angles import unit_vectors, wrap_angle
from covey.model.validation import Floats

_CLOSEST = 2.5e-7
"""Radians. Tangents that are closer count as the same, for a corner between them is ill-defined."""


class Corners(NamedTuple):
    """Straight flights (N, C) that bound what N evaders can reach from a given time on.

    The places of one evader's flights are the corners of a polygon, at every time.
    """

    positions: Floats  # (N, C, 2) at that time
    headings: Floats  # (N, C)
    speeds: Floats  # (N, C), above the evader's


def largest_displacements(off: Floats, time: float, speed: float, turn_rate: float) -> Floats:
    """Return how far an evader can get within `time` in directions `off` its heading, radians."""
    off = np.abs(wrap_angle(off))
    if math.isinf(turn_rate):
        return np.full_like(off, speed * time)
    if turn_rate == 0.0:
        return speed * time * np.cos(off)
    radius, turned = speed / turn_rate, turn_rate * time
    straight_in_the_end = speed * time - radius * (off - np.sin(off))
    still_turning = 2.0 * radius * math.sin(0.5 * turned) * np.cos(off - 0.5 * turned)
    return np.where(off <= turned, straight_in_the_end, still_turning)


def corners_of(team: Team, touching: list[Floats], known: Floats, time: float) -> Corners:
    """Return the corners of polygons around what the evaders can reach, from `time` on.

    Evader i's turn limit counts until `known[i]`; from then on it is taken to turn at once. The
    corners bound what it can reach at known[i] and later.

    Parameters
    ----------
    team
        The evaders, at time 0.
    touching
        For each evader the directions, rising within a full turn, in which its polygon touches.
    known
        (N,) times.
    time
        Of the positions that are returned; not above any of `known`.
    """
    rows = [_corners_of_one(team, i, touching[i], float(known[i]), time) for i in range(len(team))]
    most = max(len(headings) for _, headings, _ in rows)
    positions = np.empty((len(team), most, 2))
    headings, speeds = np.empty((2, len(team), most))
    for i, columns in enumerate(rows):
        # An evader with fewer corners has its last corner several times.
        for target, values in zip((positions, headings, speeds), columns, strict=True):
            target[i, : len(values)], target[i, len(values) :] = values, values[-1]
    return Corners(positions, headings, speeds)


def _corners_of_one(
    team: Team, i: int, touching: Floats, known: float, time: float
) -> tuple[Floats, Floats, Floats]:
    """Return positions (C, 2) at `time`, headings (C,) and speeds (C,) of evader i's corners."""
    around = np.append(touching, touching[0] + 2.0 * math.pi)
    around = around[np.append(np.diff(around) > _CLOSEST, True)]
    around[0] = around[-1] - 2.0 * math.pi
    speed, turn_rate = float(team.speeds[i]), float(team.turn_rates[i])
    reach = largest_displacements(around - team.headings[i], known, speed, turn_rate)
    half = 0.5 * np.diff(around)
    headings = around[:-1] + half
    speeds = speed / np.cos(half)
    along = unit_vectors(headings)
    across = np.column_stack([-along[:, 1], along[:, 0]])
    forward = 0.5 * (reach[1:] + reach[:-1]) / np.cos(half)
    sideways = 0.5 * (reach[1:] - reach[:-1]) / np.sin(half)
    flown = speeds * (known - time)
    places = team.positions[i] + (forward - flown)[:, np.newaxis] * along
    return places + sideways[:, np.newaxis] * across, headings, speeds
