"""Whether the numbers of a record agree with each other and with the rules of the game.

The flights are computed again here, by eq. 5 and not by the kernels that played the game.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from covey.model import InputError
from covey.model.angles import unit_vectors
from covey.model.validation import Floats, Ints, checked_array, choice, number, whole_number
from covey.planning.border import check_game
from covey.simulation.record import Game, GameStatus
from covey.simulation.settings import SENSING

Mask = npt.NDArray[np.bool_]

_ROUNDING = 1e-9
"""Of the largest length, time or angle of a game. 200 000 updates stay a hundred times below."""


def require_consistent(game: Game) -> None:
    """Raise InputError unless the record is one of a game by the rules.

    The message names the field, the row, and what was expected there.
    """
    _require_settings(game)
    _require_numbers(game)
    _require_times(game)
    _require_assurances(game)
    captured_rows = _capture_rows(game)
    alive = np.arange(len(game.times))[:, None] < captured_rows
    _require_outcome(game, captured_rows)
    _require_sequences(game, alive)
    _require_flights(game, alive)
    _require_disks(game, captured_rows)


def _require(holds: npt.ArrayLike, name: str, wanted: str, *, after: int = 0) -> None:
    """Raise InputError unless a condition holds, in all rows if it has rows.

    The message names the first row where it fails; `after` rows are before the first one.
    """
    rows = np.asarray(holds)
    if rows.all():
        return
    row = f"[{after + int(np.argwhere(~rows)[0][0])}]" if rows.ndim > 0 else ""
    raise InputError(f"{name}{row}: expected {wanted}")


def _require_settings(game: Game) -> None:
    """Check what a game is played with."""
    check_game(game.team, game.disk)
    choice("sensing", game.sensing, SENSING)
    number("update_time", game.update_time, low=0.0, strictly=True)
    whole_number("seed", game.seed, low=0)
    for name, described in {"objective": game.objective, **game.strategies}.items():
        _require(isinstance(described, Mapping), name, "its name and parameters")
    _require(isinstance(game.objective.get("name"), str), "objective", "a name")
    _require({"evaders", "pursuer"} == game.strategies.keys(), "strategies", "both sides")


def _require_numbers(game: Game) -> None:
    """Check shapes and kinds; that all is finite but the time of a game that was stopped."""
    rows, n, captures = len(game.times), len(game.team), len(game.capture_sequence)
    for name, shape in {
        "capture_times": (captures,),
        "times": (rows,),
        "evader_positions": (rows, n, 2),
        "evader_headings": (rows, n),
        "evader_turns": (rows, n),
        "pursuer_positions": (rows, 2),
        "disk_centers": (rows, 2),
        "disk_radii": (rows,),
    }.items():
        checked_array(name, getattr(game, name), shape)
    for name in ("critical_sequences", "pursuer_sequences"):
        _require(getattr(game, name).dtype.kind == "i", name, "whole numbers")
    for name in ("guarantee", "planned_value", "guarantees"):
        values: Floats = np.asarray(getattr(game, name), dtype=np.float64)
        _require(np.isfinite(values) & (values >= 0.0), name, "a finite number >= 0")


def _require_times(game: Game) -> None:
    steps, times = np.diff(game.times), game.times
    _require(times[0] == 0.0, "times[0]", "0")
    _require(steps >= 0.0, "times", "a time that is not after the next one")
    longest = game.update_time + _ROUNDING * (game.update_time + times[-1])
    _require(steps <= longest, "times", f"the next time at most {game.update_time:g} later")


def _require_assurances(game: Game) -> None:
    """Check that the pursuer's assurance never rises, and that nobody is alive after it."""
    assured, times = game.assurances, game.times
    kind = assured.dtype.kind == "f" and assured.shape == times.shape
    _require(kind, "assurances", f"{len(times)} numbers")
    _require(assured >= 0.0, "assurances", "a number >= 0, or inf")
    kept = assured[1:] <= assured[:-1] * (1.0 + _ROUNDING)
    _require(kept, "assurances", "no later time than the row before has", after=1)
    lasting = times[:-1] <= assured[:-1] * (1.0 + _ROUNDING)
    _require(lasting, "assurances", "a time by which everybody is captured")


def _capture_rows(game: Game) -> Ints:
    """Return the row (N,) of each evader's capture; T where it is not captured.

    Each capture is a row of its own, in which one evader less is alive than in the row before.
    """
    order, n = game.capture_sequence, len(game.team)
    _require((order >= 0) & (order < n), "capture_sequence", f"evaders 0 to {n - 1}")
    _require(len(set(order.tolist())) == len(order), "capture_sequence", "each evader once at most")
    living = (game.critical_sequences >= 0).sum(axis=1)
    falls = -np.diff(living, prepend=n)
    rows = np.flatnonzero(falls)
    one_less = falls[0] == 0 and falls[rows].tolist() == [1] * len(order)
    _require(one_less, "critical_sequences", "one evader less from the row of each capture on")
    captured_rows = np.full(n, len(game.times))
    captured_rows[order] = rows
    return captured_rows


def _require_outcome(game: Game, captured_rows: Ints) -> None:
    """Check captures, status and values against each other."""
    order = game.capture_sequence
    _require(
        game.capture_times == game.times[captured_rows[order]],
        "capture_times",
        "the time of the row of the capture",
    )
    ended = len(order) == len(game.team)
    _require(ended == (game.status is GameStatus.ALL_CAPTURED), "status", "who was captured")
    last = game.capture_times[-1] if ended else math.inf
    _require(game.survival_time == last, "survival_time", f"{last:g}, as the captures have it")
    if game.objective["name"] == "last-capture":
        _require(game.value == last, "value", f"{last:g}, the survival time")
    _require(math.isfinite(game.value) == ended, "value", "a finite number if all are captured")
    first = game.guarantees[0]
    _require(math.isclose(game.guarantee, first, rel_tol=1e-6), "guarantee", f"{first:g}")
    _require(game.guarantees[-1] == 0.0 or not ended, "guarantees[-1]", "0, as nobody is alive")


def _require_sequences(game: Game, alive: Mask) -> None:
    """Check the evaders that each row names: the living, each once, then -1."""
    numbers, n = np.arange(alive.shape[1]), alive.shape[1]
    for name, all_named in (("critical_sequences", True), ("pursuer_sequences", False)):
        sequences = getattr(game, name)
        named = sequences >= 0
        _require(
            (sequences >= -1) & (sequences < n) & (named == np.sort(named)[:, ::-1]),
            name,
            f"evaders 0 to {n - 1}, then -1",
        )
        times_named = (sequences[:, :, None] == numbers).sum(axis=1)
        wanted = times_named == alive if all_named else times_named <= alive
        _require(wanted, name, "each living evader once" + ("" if all_named else " at most"))


def _require_flights(game: Game, alive: Mask) -> None:
    """Check that the living fly the plan of each row, and that others rest."""
    headings, turns = game.evader_headings, game.evader_turns
    angle = _ROUNDING * (1.0 + float(np.abs(headings).max()))
    length = angle * _extent(game)
    _require(_near(game.evader_positions[0], game.team.positions, length), *_AS_THE_TEAM)
    _require(np.abs(headings[0] - game.team.headings) <= angle, *_AS_THE_TEAM)
    _require(np.abs(turns) <= math.pi + angle, "evader_turns", "radians in [-π, π]")
    _require((turns == 0.0) | alive, "evader_turns", "0 for captured evaders")
    positions, goals = _flown(game, alive[:-1])
    flown = "the flight that the row before has announced"
    _require(np.abs(headings[1:] - goals) <= angle, "evader_headings", flown, after=1)
    reached = _near(game.evader_positions[1:], positions, length)
    _require(reached, "evader_positions", flown, after=1)


_AS_THE_TEAM = "team", "the positions and headings of the first row"


def _flown(game: Game, alive: Mask) -> tuple[Floats, Floats]:
    """Return positions (T - 1, N, 2) and headings (T - 1, N) by the plan of the row before."""
    duration, rates = np.diff(game.times)[:, None], game.team.turn_rates
    headings, turns = game.evader_headings[:-1], game.evader_turns[:-1]
    with np.errstate(divide="ignore", invalid="ignore"):  # rates of 0 and inf
        largest = rates * duration
        turning = np.where(largest <= np.abs(turns), duration, np.abs(turns) / rates)
    turned = np.copysign(np.fmin(np.abs(turns), largest), turns)
    speeds = np.where(alive, game.team.speeds, 0.0)
    chord = speeds * turning * np.sinc(0.5 * turned / math.pi)
    straight = speeds * np.maximum(duration - turning, 0.0)
    positions = (
        game.evader_positions[:-1]
        + chord[..., None] * unit_vectors(headings + 0.5 * turned)
        + straight[..., None] * unit_vectors(headings + turned)
    )
    return positions, headings + turned


def _require_disks(game: Game, captured_rows: Ints) -> None:
    """Check the disk that the team knows: how it moves, and that the pursuer is in it."""
    disk, order, rows = game.disk, game.capture_sequence, captured_rows[game.capture_sequence]
    centers, radii, pursuer = game.disk_centers, game.disk_radii, game.pursuer_positions
    length, captured_at = _ROUNDING * _extent(game), game.evader_positions[rows, order]
    first = _near(centers[:1], disk.center, length) & (abs(radii[:1] - disk.radius) <= length)
    _require(first, "disk_centers", "the disk of the game at time 0")
    farthest = radii[:-1] + disk.speed * np.diff(game.times)
    kept_centers, kept_radii = pursuer[1:], np.zeros(len(farthest))
    if game.sensing == "hidden":
        kept_centers, kept_radii = centers[:-1].copy(), farthest.copy()
        kept_centers[rows - 1], kept_radii[rows - 1] = captured_at, disk.capture_radius
        farthest[rows - 1] += disk.capture_radius
    kept = "the disk that follows from the row before"
    _require(_near(centers[1:], kept_centers, length), "disk_centers", kept, after=1)
    _require(np.abs(radii[1:] - kept_radii) <= length, "disk_radii", kept, after=1)
    reached = _near(centers[1:], centers[:-1], farthest + length)
    _require(reached, "disk_centers", "a centre that the pursuer can have reached", after=1)
    inside = _near(pursuer, centers, radii + length)
    inside[rows] &= _near(captured_at, pursuer[rows], disk.capture_radius + length)
    _require(inside, "pursuer_positions", "a point of the disk, within reach of who is captured")


def _extent(game: Game) -> float:
    """Return the largest coordinate, radius or distance flown that goes into the arithmetic."""
    team, disk = game.team, game.disk
    largest = max(float(np.abs(team.positions).max()), float(np.abs(disk.center).max()))
    return largest + disk.radius + disk.capture_radius + disk.speed * float(game.times[-1])


def _near(points: Floats, others: Floats, distance: npt.ArrayLike) -> Mask:
    """Return whether points (..., 2) are within a distance of others."""
    near: Mask = np.hypot(*np.moveaxis(points - others, -1, 0)) <= np.asarray(distance)
    return near
