"""An upper bound of the latest last capture in a sequence: a dynamic programme over corners.

The evaders' velocities lie in disks, and the maximum over the corners of polygons around the disks
is no less than that over the disks (docs/decisions/0006). Each evader departs at its own time: it
may be anywhere before, on a way that is known.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, IntMatrix, Ints, Matrix, Tensor, Vector
from covey.kernels.capture.path import SPEED, X, Y
from covey.kernels.capture.pursuit import GrowingDisk

# A corner is a row: its direction from the heading that the polygon is dense around, its distance.
COSINE, SINE, STRETCH = range(3)
CORNER = 3

# A state is a row: the latest capture of an evader that flies to a corner, and its place.
_TIME, _X, _Y = range(3)
STATE = 3


class CornerProgramme(NamedTuple):
    """The corners of a polygon around a unit disk, and the programme's tables."""

    corners: Matrix  # (c, CORNER)
    states: Tensor  # (n, c, STATE) of the captures before each slot
    predecessor: IntMatrix  # (n, c) the corner of the evader before, with which a state is attained
    attained: Vector  # (n,) headings that attain the bound, by evader


@compiled
def latest_at_corners(
    evaders: Floats,
    departures: Floats,
    pursuer: GrowingDisk,
    reach: float,
    sequence: Ints,
    headings: Floats,
    programme: CornerProgramme,
) -> float:
    """Return an upper bound of the last capture over all flights.

    Parameters
    ----------
    evaders
        (n, EVADER) rows, at the evaders' departures; headings and turn rates are not used.
    departures
        (n,) times by evader, none after the pursuer's.
    pursuer
        A point from which the pursuer starts, and when.
    reach
        Its capture radius, which counts for the last capture only.
    sequence
        (m,) evaders in the order of capture.
    headings
        (n,) radians, by evader, around which the corners are dense.
    programme
        Modified in place. `attained` has the headings that attain the bound; that of the last
        evader is not searched for.
    """
    last = len(sequence) - 1
    start = programme.states[0, 0]
    start[_TIME], start[_X], start[_Y] = pursuer.time, pursuer.x, pursuer.y
    for k in range(last):
        i = sequence[k]
        _extend(k, evaders[i], departures[i], headings[i], pursuer.speed, programme)
    i = sequence[last]
    own, bound, corner = evaders[i, SPEED], -math.inf, 0
    for r in range(len(programme.corners) if last > 0 else 1):
        state = programme.states[last, r]
        gap = math.hypot(evaders[i, X] - state[_X], evaders[i, Y] - state[_Y])
        # The last evader flees straight from the capture before its own.
        ahead = pursuer.speed * state[_TIME] + gap - reach - own * departures[i]
        fled = max(ahead / (pursuer.speed - own), state[_TIME])
        if fled > bound:
            bound, corner = fled, r
    _write_attained(sequence, headings, corner, programme)
    return bound


@compiled
def _extend(
    k: int,
    evader: Floats,
    departure: float,
    heading: float,
    pursuer_speed: float,
    programme: CornerProgramme,
) -> None:
    """Write the states of the evader that is captured in slot k, from those of the slot before."""
    cosine, sine = math.cos(heading), math.sin(heading)
    corners, states = programme.corners, programme.states
    for c in range(len(corners)):
        speed = evader[SPEED] * corners[c, STRETCH]
        velocity_x = speed * (cosine * corners[c, COSINE] - sine * corners[c, SINE])
        velocity_y = speed * (sine * corners[c, COSINE] + cosine * corners[c, SINE])
        line_x = evader[X] - velocity_x * departure
        line_y = evader[Y] - velocity_y * departure
        closing = (pursuer_speed - speed) * (pursuer_speed + speed)
        latest = -math.inf
        for r in range(len(corners) if k > 0 else 1):
            time = states[k, r, _TIME]
            gap_x = line_x + velocity_x * time - states[k, r, _X]
            gap_y = line_y + velocity_y * time - states[k, r, _Y]
            along = gap_x * velocity_x + gap_y * velocity_y
            outside = gap_x * gap_x + gap_y * gap_y
            time += (along + math.sqrt(along * along + closing * outside)) / closing
            if time > latest:
                latest = time
                programme.predecessor[k, c] = r
        states[k + 1, c, _TIME] = latest
        states[k + 1, c, _X] = line_x + velocity_x * latest
        states[k + 1, c, _Y] = line_y + velocity_y * latest


@compiled
def _write_attained(
    sequence: Ints, headings: Floats, corner: int, programme: CornerProgramme
) -> None:
    """Write the headings that lead to the last but one evader's corner."""
    last = len(sequence) - 1
    programme.attained[sequence[last]] = headings[sequence[last]]
    for k in range(last - 1, -1, -1):
        row = programme.corners[corner]
        turn = math.atan2(row[SINE], row[COSINE])
        programme.attained[sequence[k]] = headings[sequence[k]] + turn
        corner = programme.predecessor[k, corner]
