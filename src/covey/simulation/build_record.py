"""From the log that the kernels wrote to the record of a game."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from covey.kernels.play.game import GameLog, cut_log
from covey.model import PursuerDisk, Team, objective_value
from covey.model.validation import Floats
from covey.planning.guarantee import value_of_plan
from covey.simulation.record import Game, GameStatus
from covey.simulation.settings import Settings


class GameSetup(NamedTuple):
    """What a game is played with."""

    team: Team
    disk: PursuerDisk
    settings: Settings
    strategies: Mapping[str, Mapping[str, Any]]  # descriptions of "evaders" and "pursuer"
    has_position: bool = False  # whether the pursuer has a position, even where it is hidden


def build_record(setup: GameSetup, log: GameLog) -> Game:
    """Return the record of what has happened."""
    team, disk, settings, strategies, has_position = setup
    log = cut_log(log)
    order, times = log.order, log.capture_times
    done, objective = len(order) == len(team), settings.objective
    pursuer = log.pursuers[:, :2]
    if settings.sensing == "hidden" and not has_position:
        pursuer = _explaining_flight(disk, log)
    return Game(
        team=team,
        disk=disk,
        sensing=settings.sensing,
        update_time=settings.update_time,
        seed=settings.seed,
        objective=objective.describe(),
        strategies=strategies,
        status=_status(done, settings, log),
        guarantee=float(log.guarantees[0]),
        survival_time=float(times[-1]) if done else math.inf,
        planned_value=value_of_plan(team, disk, log.evaders[0, :, 3], objective),
        value=objective_value(objective, times) if done else math.inf,
        capture_sequence=order,
        capture_times=times,
        times=log.times,
        evader_positions=log.evaders[:, :, :2],
        evader_headings=log.evaders[:, :, 2],
        evader_turns=log.evaders[:, :, 3],
        guarantees=log.guarantees,
        critical_sequences=log.critical,
        pursuer_sequences=log.intended,
        pursuer_positions=pursuer,
        disk_centers=log.pursuers[:, 2:4],
        disk_radii=log.pursuers[:, 4],
    )


def _status(done: bool, settings: Settings, log: GameLog) -> GameStatus:
    if done:
        return GameStatus.ALL_CAPTURED
    in_time = log.times[-1] < settings.time_limit
    return GameStatus.UPDATE_LIMIT if in_time else GameStatus.TIME_LIMIT


def _explaining_flight(disk: PursuerDisk, log: GameLog) -> Floats:
    """Straight flights, one to each capture, from where in the disk it was nearest.

    With a capture radius ρ the flight may start anew up to 2ρ from where the last one ended: that
    is the freedom which the guarantee allows the pursuer.
    """
    places = np.empty((len(log.times), 2))
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
        places[row:last] = start + share[:, None] * (end - start)
        disk = PursuerDisk(goal, disk.capture_radius, disk.speed, disk.capture_radius)
        since, row = time, last
    places[row:] = disk.center
    return places
