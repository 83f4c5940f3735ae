"""Parallel approach: the pursuer flies so that the line of sight to its target keeps its bearing.

The evaders have announced their flights until the next update. In that time a target may turn, so
the pursuer keeps the bearing at the end of the flight, against the target's displacement: its
announced flight is as good for the pursuer as the chord of that flight (docs/decisions/0014).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from covey.kernels.capture.path import TURN_END, sample
from covey.kernels.play.first_contact import Flight, first_contact
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.planning import capture_times
from covey.planning.border import paths_of
from covey.simulation import Situation

_MOST_CORRECTIONS = 20

_SETTLED = 1e-12
"""Relative difference up to which two durations of a flight are the same."""


def approaches(situation: Situation, row: int) -> list[tuple[float, float]]:
    """Return velocities of a pursuer at a point that approaches the evader in a row.

    None if, without a capture radius, the pursuer can meet the evader before the next update:
    flight to the point of meeting is then parallel approach to the chord.

    One if it keeps the bearing until the flight ends: at the next update or, with a capture radius,
    at the first contact with any evader. Two if no velocity does: with the first the pursuer just
    misses an evader, with the second it touches that evader.
    """
    pursuer, longest = situation.pursuer, situation.until_update
    paths = paths_of(situation.team, pursuer, situation.turns)
    if _distance(pursuer.center, _position(paths, row, longest)) <= pursuer.speed * longest:
        if pursuer.capture_radius == 0.0:
            return []
        longest = _meeting_time(situation, row)
    if pursuer.capture_radius == 0.0 or paths[row, TURN_END] == 0.0:
        return [_velocity(pursuer, paths, row, longest)]

    def ended(supposed: float) -> float:
        velocity = _velocity(pursuer, paths, row, supposed)
        return float(_contacts(pursuer, paths, velocity, longest).min(initial=longest))

    return [_velocity(pursuer, paths, row, each) for each in _consistent_durations(ended, longest)]


def _consistent_durations(ended: Callable[[float], float], longest: float) -> list[float]:
    """Return the duration of a flight whose bearing is kept until it ends.

    `ended` gives the end of the flight that keeps the bearing until a supposed end. It is at most
    `longest`. Where a flight begins to touch an evader that it passes, it jumps: then two durations
    are returned, from both sides of the jump.
    """
    supposed = longest
    for _ in range(_MOST_CORRECTIONS):
        end = ended(supposed)
        if abs(end - supposed) <= _SETTLED * longest:
            return [supposed]
        supposed = end
    shorter, longer = 0.0, longest
    while longer - shorter > _SETTLED * longest:
        middle = 0.5 * (shorter + longer)
        shorter, longer = (middle, longer) if ended(middle) > middle else (shorter, middle)
    return [shorter, longer]


def after_flight(
    situation: Situation, velocity: tuple[float, float]
) -> tuple[float, Situation | None]:
    """Return when a flight ends, and the situation then; None if everybody is captured."""
    pursuer, latest = situation.pursuer, situation.until_update
    paths = paths_of(situation.team, pursuer, situation.turns)
    contacts = _contacts(pursuer, paths, velocity, latest)
    duration = float(contacts.min(initial=latest))
    rows = np.flatnonzero(contacts > duration).tolist()
    time = situation.time + duration
    if not rows:
        return time, None
    positions = np.array([_position(paths, row, duration) for row in rows])
    left = situation.team.take(np.array(rows, np.int64))
    return time, replace(
        situation,
        time=time,
        evaders=tuple(situation.evaders[row] for row in rows),
        team=Team(positions, left.headings, left.speeds, left.turn_rates),
        turns=situation.turns[rows],
        place=pursuer.center + duration * np.array(velocity),
    )


def _contacts(
    pursuer: PursuerDisk, paths: Floats, velocity: tuple[float, float], latest: float
) -> Floats:
    """Return the first times (N,) within reach of each evader; inf if not by `latest`."""
    x, y = pursuer.center.tolist()
    flight = Flight(x, y, *velocity, pursuer.capture_radius)
    with np.errstate(divide="ignore", invalid="ignore"):  # as compiled: no contact is at infinity
        return np.array([first_contact(paths, i, flight, latest) for i in range(len(paths))])


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
    return float(
        capture_times(
            situation.team.take(np.array(rows, np.int64)), point, situation.turns[rows], [0]
        )[0]
    )


def _position(paths: Floats, row: int, time: float) -> Floats:
    """Return the position (2,) of an evader at a time."""
    positions = np.empty((1, 1, 2))
    sample(paths[row : row + 1], np.array([time]), positions)
    position: Floats = positions[0, 0]
    return position


def _distance(a: Floats, b: Floats) -> float:
    return float(np.hypot(*(a - b)))
