"""From a game as it was played to its outcome and its record."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels.play.game import GameLog, cut_log
from covey.model import PursuerDisk, objective_value
from covey.model.validation import Floats
from covey.simulation.record import Game, GameStatus, Outcome
from covey.simulation.settings import GameSetup
from covey.simulation.time_series import time_series


class Played(NamedTuple):
    """A game as it was played, compiled or in Python."""

    setup: GameSetup
    guarantee: float  # survival time that the first plan guaranteed
    planned_value: float  # of the objective, by the first plan
    log: GameLog  # without rows if the game wasn't recorded
    assurances: Floats | None = None  # (T,) the pursuer's; None: it assured nothing


def outcome_of(played: Played) -> Outcome:
    """Return what came of a game."""
    log, objective = cut_log(played.log), played.setup.settings.objective
    all_captured = len(log.order) == len(played.setup.team)
    return Outcome(
        guarantee=played.guarantee,
        survival_time=float(log.capture_times[-1]) if all_captured else math.inf,
        planned_value=played.planned_value,
        value=objective_value(objective, log.capture_times) if all_captured else math.inf,
        capture_sequence=log.order,
        capture_times=log.capture_times,
    )


def build_record(played: Played) -> Game:
    """Return the record of a game that was recorded.

    The log tells where a pursuer was that is visible or has a position of its own.
    """
    setup, log = played.setup, _moved(cut_log(played.log), played.setup.disk.center)
    series = {field: each.logged(log) for field, each in time_series(len(setup.team)).items()}
    if played.assurances is not None:
        series["assurances"] = played.assurances
    if setup.settings.sensing == "hidden" and setup.position is None:
        series["pursuer_positions"] = _explaining_flight(setup.disk, log)
    return Game(
        team=setup.team,
        disk=setup.disk,
        sensing=setup.settings.sensing,
        update_time=setup.settings.update_time,
        seed=setup.settings.seed,
        objective=setup.settings.objective.describe(),
        strategies=setup.strategies,
        status=_status(setup, log),
        **outcome_of(played)._asdict(),
        **series,
    )


def _moved(log: GameLog, by: Floats) -> GameLog:
    """Return the log of a game, from its own frame moved `by` (2,)."""
    if not by.any():
        return log
    evaders, pursuers = log.evaders.copy(), log.pursuers.copy()
    evaders[:, :, :2] += by
    pursuers[:, :4] += np.tile(by, 2)
    return log._replace(evaders=evaders, pursuers=pursuers)


def _status(setup: GameSetup, log: GameLog) -> GameStatus:
    if len(log.order) == len(setup.team):
        return GameStatus.ALL_CAPTURED
    in_time = log.times[-1] < setup.settings.time_limit
    return GameStatus.UPDATE_LIMIT if in_time else GameStatus.TIME_LIMIT


def _explaining_flight(disk: PursuerDisk, log: GameLog) -> Floats:
    """Return positions (T, 2) on straight flights, one to each capture, that explain the captures.

    Each flight begins at the disk's point nearest to the capture. With a capture radius ρ this may
    be up to 2ρ from the end of the flight before: the guarantee allows the pursuer that much.
    """
    positions = np.empty((len(log.times), 2))
    since, row = 0.0, 0
    living = (log.critical >= 0).sum(axis=1)
    for k, (i, time) in enumerate(zip(log.order, log.capture_times, strict=True)):
        last = int(np.argmax(living < living[0] - k)) + 1  # behind the row of this capture
        goal = log.evaders[-1, i, :2]
        distance = float(np.hypot(*(goal - disk.center)))
        start = disk.nearest_point(goal)
        end = disk.towards(goal, max(distance - disk.capture_radius, disk.radius))
        share = np.ones(last - row)
        if time > since:
            share = (log.times[row:last] - since) / (time - since)
        positions[row:last] = start + share[:, None] * (end - start)
        disk = PursuerDisk(goal, disk.capture_radius, disk.speed, disk.capture_radius)
        since, row = time, last
    positions[row:] = disk.center
    return positions
