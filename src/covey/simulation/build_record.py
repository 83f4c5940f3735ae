"""From a game as it was played to its outcome and its record."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels.play.game import Pages
from covey.model import PursuerDisk, measured
from covey.model.validation import Floats, Ints
from covey.simulation.record import Game, GameStatus, Outcome
from covey.simulation.settings import GameSetup
from covey.simulation.time_series import time_series


class Played(NamedTuple):
    """A game as it was played, compiled or in Python."""

    setup: GameSetup
    guarantee: float  # survival time that the first plan guaranteed
    planned_value: float  # of the objective, by the first plan
    captured: Ints  # (C,) in the order of their capture
    capture_times: Floats  # (C,)
    log: Pages
    rows: int  # written in the log; 0 if the game wasn't recorded


def outcome_of(played: Played) -> Outcome:
    """Return what came of a game."""
    times, objective = played.capture_times, played.setup.settings.objective
    all_captured = len(times) == len(played.setup.team)
    return Outcome(
        guarantee=played.guarantee,
        survival_time=float(times[-1]) if all_captured else math.inf,
        planned_value=played.planned_value,
        value=measured(objective, times) if all_captured else math.inf,
        capture_sequence=played.captured,
        capture_times=times,
    )


def build_record(played: Played) -> Game:
    """Return the record of a game that was logged.

    The log tells where a pursuer was that is visible or has a position of its own.
    """
    setup, settings = played.setup, played.setup.settings
    log = Pages._make(array[: played.rows] for array in played.log)
    series = {field: each.logged(log) for field, each in time_series(len(setup.team)).items()}
    if settings.sensing == "hidden" and setup.position is None:
        series["pursuer_positions"] = _explaining_flight(
            setup.disk, played.captured, played.capture_times, log
        )
    return Game(
        team=setup.team,
        disk=setup.disk,
        sensing=settings.sensing,
        update_time=settings.update_time,
        seed=settings.seed,
        objective=settings.objective.describe(),
        strategies=setup.strategies,
        status=_status(played, float(log.times[-1])),
        **outcome_of(played)._asdict(),
        **series,
    )


def _status(played: Played, end: float) -> GameStatus:
    if len(played.captured) == len(played.setup.team):
        return GameStatus.ALL_CAPTURED
    in_time = end < played.setup.settings.time_limit
    return GameStatus.UPDATE_LIMIT if in_time else GameStatus.TIME_LIMIT


def _explaining_flight(disk: PursuerDisk, order: Ints, times: Floats, log: Pages) -> Floats:
    """Return positions (T, 2) on straight flights, one to each capture, that explain the captures.

    Each flight begins at the disk's point nearest to the capture. With a capture radius ρ this may
    be up to 2ρ from the end of the flight before: the guarantee allows the pursuer that much.
    """
    positions = np.empty((len(log.times), 2))
    center, radius, since, row = disk.center, disk.radius, 0.0, 0
    living = (log.critical >= 0).sum(axis=1)
    for k, (i, time) in enumerate(zip(order, times, strict=True)):
        last = int(np.argmax(living < living[0] - k)) + 1  # behind the row of this capture
        goal = log.evaders[-1, i, :2]
        off = goal - center
        distance = float(np.hypot(*off))
        towards = off / distance if distance > 0.0 else np.zeros(2)
        start = center + min(radius, distance) * towards
        end = center + max(distance - disk.capture_radius, min(radius, distance)) * towards
        share = np.ones(last - row)
        if time > since:
            share = (log.times[row:last] - since) / (time - since)
        positions[row:last] = start + share[:, None] * (end - start)
        center, radius, since, row = goal, disk.capture_radius, time, last
    positions[row:] = center
    return positions
