"""What the players know when they decide, and the checks of what they decided."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from covey.kernels.play.rules import NOBODY, Rules, State
from covey.model import InputError, LastCapture, Objective, PursuerDisk, Team
from covey.model.validation import Floats, Ints, frozen_array, number, read_only, shown
from covey.simulation.strategy import Chase, Fly, Situation

ROUNDING = 1e-9
"""Relative, of an assured time."""


def team_information(
    state: State,
    disk: PursuerDisk,
    objective: Objective = LastCapture(),  # noqa: B008 frozen
) -> Situation:
    """Return what the team knows; `disk` gives the pursuer's speed and reach."""
    alive = int(state.alive[0])
    rows = state.evaders[:alive]
    return Situation(
        time=float(state.time[0]),
        evaders=tuple(state.ids[:alive].tolist()),
        team=Team(rows[:, :2], rows[:, 2], rows[:, 3], rows[:, 4], unit=disk.unit),
        disk=replace(disk, center=state.disk[:2], radius=state.disk[2]),
        turns=read_only(state.turns[:alive].copy()),
        objective=objective,
    )


def pursuer_information(
    known_to_team: Situation, state: State, rules: Rules, *, moves: bool
) -> Situation:
    """Return what the pursuer knows: also the new turns and, if it `moves`, its position.

    In a game that began with a disk, a visible pursuer has no position before it first moves.
    """
    has_position = moves and state.pursuer[2] == 0.0
    return replace(
        known_to_team,
        turns=read_only(state.turns[: len(known_to_team.turns)].copy()),
        place=read_only(state.pursuer[:2].copy()) if has_position else None,
        until_update=min(rules.update_time, rules.time_limit - known_to_team.time),
        chooses_start=moves and not has_position,
    )


def checked_turns(turns: object, alive: int) -> Floats:
    """Return what the team decided, (alive,) turns in [-π, π]."""
    checked = frozen_array("turns returned by the team's strategy", turns, (alive,))
    if np.abs(checked).max() > math.pi:
        raise InputError(
            f"turns returned by the team's strategy: expected radians in [-π, π], "
            f"got {checked.tolist()}"
        )
    return checked


class Decision(NamedTuple):
    """A decision of the pursuer that the rules allow."""

    rows: Ints  # of the living: its sequence
    target: int  # a row, or `NOBODY`; then the velocity counts
    velocity: tuple[float, float]
    offset: tuple[float, float]  # from the disk's centre, of a pursuer that chooses its start
    assurance: float


def checked_decision(decision: object, known: Situation, *, moves: bool) -> Decision:
    """Return what a pursuer decided that knew this.

    A pursuer that doesn't move is a disk, and its velocity must be 0.
    """
    if not isinstance(decision, Chase | Fly):
        raise InputError(f"pursuer's decision: expected Chase or Fly, got {shown(decision)}")
    name = type(decision).__name__
    least = 1 if isinstance(decision, Chase) else 0
    rows = _chosen_rows(name, decision.sequence, known.evaders, least)
    assurance = _assured(name, decision.assurance)
    if isinstance(decision, Fly):
        velocity = _chosen_velocity(decision, known.disk, moves=moves)
        return Decision(rows, NOBODY, velocity, _chosen_offset(decision, known), assurance)
    return Decision(rows, int(rows[0]), (0.0, 0.0), (0.0, 0.0), assurance)


def _chosen_rows(name: str, chosen: Sequence[int], living: Sequence[int], least: int) -> Ints:
    sequence, distinct = list(chosen), set(chosen)
    if not least <= len(sequence) == len(distinct) or not distinct <= set(living):
        raise InputError(
            f"{name}: expected a sequence of living evaders {list(living)}, got {shown(sequence)}"
        )
    return np.array([living.index(i) for i in sequence], dtype=np.int64)


def _assured(name: str, assurance: float) -> float:
    if assurance == math.inf:
        return assurance
    return number(f"{name}.assurance", assurance, low=0.0)


def require_kept_assurance(assurance: float, time: float, before: Sequence[float]) -> None:
    """Raise InputError if an assurance is above the one before, or if its time has passed."""
    low, high = time, before[-1] if before else math.inf
    if not low * (1.0 - ROUNDING) <= assurance <= high * (1.0 + ROUNDING):
        raise InputError(
            f"assurance of the pursuer at time {time:g}: expected a time in [{low:g}, {high:g}], "
            f"got {assurance:g}; it never rises, and everybody is captured by it"
        )


def _chosen_offset(fly: Fly, known: Situation) -> tuple[float, float]:
    x, y = frozen_array("Fly.offset", fly.offset, (2,)).tolist()
    largest = known.disk.radius if known.chooses_start else 0.0
    if math.hypot(x, y) > largest * (1.0 + 1e-12):
        raise InputError(
            f"Fly.offset: expected a point at most {largest:g} from the disk's centre, "
            f"got {[x, y]}; only a visible pursuer chooses its start in the disk, at time 0"
        )
    return x, y


def _chosen_velocity(fly: Fly, disk: PursuerDisk, *, moves: bool) -> tuple[float, float]:
    velocity = frozen_array("Fly.velocity", fly.velocity, (2,))
    speed = float(np.hypot(*velocity))
    if speed > disk.speed * (1.0 + 1e-12):
        raise InputError(f"Fly: expected a speed of at most {disk.speed:g}, got {speed:g}")
    if not moves and speed > 0.0:
        raise InputError(
            "Fly: a hidden pursuer is known as a disk only and can't be steered; "
            "return Chase((...)) to name its next target, or Fly() to wait, or give its "
            "strategy a place"
        )
    return float(velocity[0]), float(velocity[1])
