"""From the pages that the kernels wrote to the record of a game."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from covey.kernels.play.game import Pages
from covey.model import PursuerDisk, Team, objective_value
from covey.model.validation import Floats, Ints
from covey.planning.guarantee import value_of_plan
from covey.simulation.record import Game, GameStatus
from covey.simulation.settings import Settings


def assemble(
    team: Team,
    disk: PursuerDisk,
    settings: Settings,
    strategies: Mapping[str, Mapping[str, Any]],
    order: Ints,
    times: Floats,
    pages: Pages,
    count: int,
    *,
    placed: bool = False,
) -> Game:
    """Return the record; `order` and `times` hold the captures, `pages` `count` rows.

    The pages tell where a visible pursuer was, and one that was `placed`.
    """
    pages = Pages(
        pages.times[:count],
        pages.guarantees[:count],
        pages.evaders[:count],
        pages.pursuers[:count],
        pages.critical[:count],
        pages.intended[:count],
    )
    done, objective = len(order) == len(team), settings.objective
    pursuer = pages.pursuers[:, :2]
    if settings.sensing == "hidden" and not placed:
        pursuer = _explaining_flight(disk, order, times, pages)
    return Game(
        team=team,
        disk=disk,
        sensing=settings.sensing,
        update_time=settings.update_time,
        seed=settings.seed,
        objective=objective.describe(),
        strategies=strategies,
        status=_status(done, settings, pages),
        guarantee=float(pages.guarantees[0]),
        survival_time=float(times[-1]) if done else math.inf,
        planned_value=value_of_plan(team, disk, pages.evaders[0, :, 3], objective),
        value=objective_value(objective, times) if done else math.inf,
        capture_sequence=order,
        capture_times=times,
        times=pages.times,
        evader_positions=pages.evaders[:, :, :2],
        evader_headings=pages.evaders[:, :, 2],
        evader_turns=pages.evaders[:, :, 3],
        guarantees=pages.guarantees,
        critical_sequences=pages.critical,
        pursuer_sequences=pages.intended,
        pursuer_positions=pursuer,
        disk_centers=pages.pursuers[:, 2:4],
        disk_radii=pages.pursuers[:, 4],
    )


def _status(done: bool, settings: Settings, pages: Pages) -> GameStatus:
    if done:
        return GameStatus.ALL_CAPTURED
    in_time = pages.times[-1] < settings.time_limit
    return GameStatus.UPDATE_LIMIT if in_time else GameStatus.TIME_LIMIT


def _explaining_flight(disk: PursuerDisk, order: Ints, times: Floats, pages: Pages) -> Floats:
    """Straight flights, one to each capture, from where in the disk it was nearest.

    With a capture radius ρ the flight may start anew up to 2ρ from where the last one ended: that
    is the freedom which the guarantee allows the pursuer.
    """
    places = np.empty((len(pages.times), 2))
    since, row = 0.0, 0
    living = (pages.critical >= 0).sum(axis=1)
    for k, (i, time) in enumerate(zip(order, times, strict=True)):
        last = int(np.argmax(living < living[0] - k)) + 1  # behind the row of this capture
        goal = pages.evaders[-1, i, :2]
        distance = float(np.hypot(*(goal - disk.center)))
        start = disk.nearest_point(goal)
        end = disk.towards(goal, max(distance - disk.capture_radius, disk.radius))
        share = np.ones(last - row)
        if time > since:
            share = (pages.times[row:last] - since) / (time - since)
        places[row:last] = start + share[:, None] * (end - start)
        disk = PursuerDisk(goal, disk.capture_radius, disk.speed, disk.capture_radius)
        since, row = time, last
    places[row:] = disk.center
    return places
