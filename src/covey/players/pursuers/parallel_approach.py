"""Parallel approach: the pursuer flies so that the line of sight to its target keeps its bearing.

The evaders have announced their flights until the next update. In that time a target may turn, so
the pursuer keeps the bearing at the end of the flight, against the target's displacement: its
announced flight is as good for the pursuer as the chord of that flight (docs/decisions/0014).
"""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.capture.path import TURN_END, sample
from covey.kernels.play.first_contact import Flight, first_contact
from covey.model import PursuerDisk
from covey.model.validation import Floats
from covey.planning import capture_times
from covey.planning.guarantee import paths_of
from covey.simulation import Situation

_MOST_CORRECTIONS = 20

_SETTLED = 1e-13
"""Relative change of a flight's duration at which it is taken to be the time of the contact."""


def approach(situation: Situation, row: int) -> tuple[float, float] | None:
    """Return the velocity of a pursuer at a point that approaches the evader in a row.

    None if, without a capture radius, the pursuer can meet the evader before the next update:
    flight to the point of meeting is then parallel approach to the chord.

    With a capture radius the flight ends at the first contact with any evader, so the bearing is
    kept until that time.
    """
    pursuer, duration = situation.pursuer, situation.until_update
    paths = paths_of(situation.team, pursuer, situation.turns)
    if _distance(pursuer.center, _position(paths, row, duration)) <= pursuer.speed * duration:
        if pursuer.capture_radius == 0.0:
            return None
        duration = _meeting_time(situation, row)
    velocity = _velocity(pursuer, paths, row, duration)
    if pursuer.capture_radius == 0.0 or paths[row, TURN_END] == 0.0:
        return velocity
    for _ in range(_MOST_CORRECTIONS):
        contact = _first_contact(pursuer, paths, velocity, duration)
        if not 0.0 < contact < duration * (1.0 - _SETTLED):
            break
        duration = contact
        velocity = _velocity(pursuer, paths, row, duration)
    return velocity


def _velocity(
    pursuer: PursuerDisk, paths: Floats, row: int, duration: float
) -> tuple[float, float]:
    """Return the velocity that keeps the bearing of an evader from now to the end of a flight.

    The pursuer flies s = c + μ d with |s| = v_p duration, where d is the line of sight, c the
    evader's displacement, and μ the share by which the line of sight shortens.
    """
    now, then = _position(paths, row, 0.0), _position(paths, row, duration)
    sight, displacement = now - pursuer.center, then - now
    squared, along = float(sight @ sight), float(displacement @ sight)
    gain = (pursuer.speed * duration) ** 2 - float(displacement @ displacement)
    if not (squared > 0.0 and gain > 0.0):
        return 0.0, 0.0
    flown = displacement + (math.sqrt(along**2 + squared * gain) - along) / squared * sight
    x, y = (pursuer.speed / np.hypot(*flown) * flown).tolist()
    return x, y


def _meeting_time(situation: Situation, row: int) -> float:
    """Return when a pursuer without a capture radius can meet an evader."""
    pursuer, rows = situation.pursuer, np.array([row])
    point = PursuerDisk(pursuer.center, 0.0, pursuer.speed)
    return float(capture_times(situation.team.take(rows), point, situation.turns[rows], [0])[0])


def _first_contact(
    pursuer: PursuerDisk, paths: Floats, velocity: tuple[float, float], latest: float
) -> float:
    """Return when the pursuer first comes within reach of an evader; inf if not by `latest`."""
    x, y = pursuer.center.tolist()
    flight = Flight(x, y, *velocity, pursuer.capture_radius)
    return min(first_contact(paths, i, flight, latest) for i in range(len(paths)))


def _position(paths: Floats, row: int, time: float) -> Floats:
    """Return the position (2,) of an evader at a time."""
    positions = np.empty((1, 1, 2))
    sample(paths[row : row + 1], np.array([time]), positions)
    position: Floats = positions[0, 0]
    return position


def _distance(a: Floats, b: Floats) -> float:
    return float(np.hypot(*(a - b)))
