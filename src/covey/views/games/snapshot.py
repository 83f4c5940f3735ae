"""A game at any time: between two rows of its record everyone flies the plan of the first one."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats, Ints
from covey.simulation import Game
from covey.views.games.flight import after, places

_SAMPLES = 400
"""Least number of points along the trajectories of a game, which its rows may be far apart for."""


@dataclass(frozen=True, eq=False)
class Moment:
    """The state of a game at one time.

    Attributes
    ----------
    time : float
    team, turns : Team, numpy.ndarray
        All N evaders, the captured ones at rest, and the (N,) turns that are still planned.
    alive : numpy.ndarray
        (N,) bool.
    disk : PursuerDisk
        Where the pursuer can be, for all that the team knows.
    pursuer, pursuer_heading : numpy.ndarray, float
        Where it is, (2,), and where it flies, radians.
    guaranteed : float
        Time until which the plan guarantees that somebody lives.
    sequence : numpy.ndarray
        The living in the order in which the plan would be captured earliest.
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
    """Where everyone has been: K times, evaders (K, N, 2) and the pursuer (K, 2)."""

    times: Floats
    evaders: Floats
    pursuer: Floats


def end_of(game: Game) -> float:
    """Time of the last row: the last capture, or the limit at which the game was stopped."""
    return float(game.times[-1])


def moment_at(game: Game, time: float) -> Moment:
    """The state of `game` at `time`, from 0 to its end; at a capture, just after it."""
    row = int(np.searchsorted(game.times, time, side="right")) - 1
    elapsed = time - float(game.times[row])
    alive = _alive(game, row)
    team, turns = after(_team(game, row), game.evader_turns[row], elapsed)
    sequence = game.critical_sequences[row]
    return Moment(
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
    """The whole game at all of its rows, and often enough in between for smooth lines."""
    times = np.union1d(game.times, np.linspace(0.0, end_of(game), _SAMPLES))
    rows = np.searchsorted(game.times, times, side="right") - 1
    stretches = [
        places(_team(game, row), game.evader_turns[row], times[rows == row] - game.times[row])
        for row in np.unique(rows).tolist()
    ]
    return Trajectories(times, np.concatenate(stretches), _pursuer_at(game, times))


def until(flown: Trajectories, moment: Moment) -> Trajectories:
    """The part of the trajectories that has been flown, up to the moment itself."""
    count = int(np.searchsorted(flown.times, moment.time))
    return Trajectories(
        np.append(flown.times[:count], moment.time),
        np.concatenate([flown.evaders[:count], moment.team.positions[None]]),
        np.concatenate([flown.pursuer[:count], moment.pursuer[None]]),
    )


def capture_points(game: Game) -> Floats:
    """Where the evaders of `capture_sequence` were captured, (C, 2)."""
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
    # Its motion is simple, so between two rows it flies straight.
    x, y = (np.interp(times, game.times, game.pursuer_positions[:, axis]) for axis in (0, 1))
    return np.column_stack([x, y])


def _pursuer_heading(game: Game, row: int) -> float:
    """Where it goes from `row` on; where it came from if it goes nowhere any more."""
    steps = np.diff(game.pursuer_positions, axis=0)
    moving = np.flatnonzero(np.hypot(*steps.T) > 0.0)
    if moving.size == 0:
        return 0.0
    ahead = moving[moving >= row]
    x, y = steps[ahead[0] if ahead.size else moving[-1]].tolist()
    return math.atan2(y, x)
