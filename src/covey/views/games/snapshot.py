"""A game at any time. Between two rows of its record, all fly the plan of the earlier row."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats, Ints
from covey.simulation import Game
from covey.views.games.flight import advance, positions_at

_SAMPLES = 400
"""Least number of points along the trajectories of a game: its rows may be far apart."""


@dataclass(frozen=True, eq=False)
class Snapshot:
    """The state of a game at one time.

    Attributes
    ----------
    time : float
    team, turns : Team, numpy.ndarray
        All N evaders, captured ones at rest, and the (N,) turns that remain of the plan.
    alive : numpy.ndarray
        (N,) bool.
    disk : PursuerDisk
        All positions of the pursuer that the team must reckon with.
    pursuer, pursuer_heading : numpy.ndarray, float
        Position (2,) and heading, radians.
    guaranteed : float
        Time of the last capture that the plan guarantees.
    sequence : numpy.ndarray
        The living, in the order of the earliest capture of the plan.
    """

    time: float
    team: Team
    turns: Floats
    alive: npt.NDArray[np.bool_]
    disk: PursuerDisk
    pursuer: Floats
    pursuer_heading: float
    guaranteed: float
    sequence: Ints


@dataclass(frozen=True, eq=False)
class Trajectories:
    """Positions at K times: evaders (K, N, 2) and the pursuer (K, 2)."""

    times: Floats
    evaders: Floats
    pursuer: Floats


def end_of(game: Game) -> float:
    """Time of the last row: the last capture, or the time limit."""
    return float(game.times[-1])


def snapshot_at(game: Game, time: float) -> Snapshot:
    """The state of `game` at `time`, from 0 to its end; at a capture, just after it."""
    row = int(np.searchsorted(game.times, time, side="right")) - 1
    elapsed = time - float(game.times[row])
    alive = _alive(game, row)
    team, turns = advance(_team(game, row), game.evader_turns[row], elapsed)
    sequence = game.critical_sequences[row]
    return Snapshot(
        time=time,
        team=team,
        turns=turns,
        alive=alive,
        disk=PursuerDisk(
            game.disk_centers[row],
            game.disk_radii[row] + game.disk.speed * elapsed,
            game.disk.speed,
            game.disk.capture_radius,
        ),
        pursuer=_pursuer_at(game, np.array([time]))[0],
        pursuer_heading=_pursuer_heading(game, row),
        guaranteed=float(game.times[row] + game.guarantees[row]),
        sequence=sequence[sequence >= 0],
    )


def trajectories(game: Game) -> Trajectories:
    """The whole game, at all rows and often enough in between for smooth lines."""
    times = np.union1d(game.times, np.linspace(0.0, end_of(game), _SAMPLES))
    rows = np.searchsorted(game.times, times, side="right") - 1
    stretches = [
        positions_at(_team(game, row), game.evader_turns[row], times[rows == row] - game.times[row])
        for row in np.unique(rows).tolist()
    ]
    return Trajectories(times, np.concatenate(stretches), _pursuer_at(game, times))


def until(flown: Trajectories, snapshot: Snapshot) -> Trajectories:
    """The part of the trajectories up to a snapshot, whose positions are the last."""
    count = int(np.searchsorted(flown.times, snapshot.time))
    return Trajectories(
        np.append(flown.times[:count], snapshot.time),
        np.concatenate([flown.evaders[:count], snapshot.team.positions[None]]),
        np.concatenate([flown.pursuer[:count], snapshot.pursuer[None]]),
    )


def capture_points(game: Game) -> Floats:
    """Positions (C, 2) at which the evaders of `capture_sequence` were captured."""
    points: Floats = game.evader_positions[-1, game.capture_sequence]
    return points


def _alive(game: Game, row: int) -> npt.NDArray[np.bool_]:
    alive = np.ones(len(game.team), dtype=np.bool_)
    alive[game.capture_sequence[game.capture_times <= game.times[row]]] = False
    return alive


def _team(game: Game, row: int) -> Team:
    return Team(
        game.evader_positions[row],
        game.evader_headings[row],
        np.where(_alive(game, row), game.team.speeds, 0.0),
        game.team.turn_rates,
    )


def _pursuer_at(game: Game, times: Floats) -> Floats:
    # The pursuer's motion is simple: between two rows it flies straight.
    x, y = (np.interp(times, game.times, game.pursuer_positions[:, axis]) for axis in (0, 1))
    return np.column_stack([x, y])


def _pursuer_heading(game: Game, row: int) -> float:
    """Heading of the pursuer's next move from `row` on, or of its last move if there is none."""
    steps = np.diff(game.pursuer_positions, axis=0)
    moving = np.flatnonzero(np.hypot(*steps.T) > 0.0)
    if moving.size == 0:
        return 0.0
    ahead = moving[moving >= row]
    x, y = steps[ahead[0] if ahead.size else moving[-1]].tolist()
    return math.atan2(y, x)
