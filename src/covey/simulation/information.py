"""What the players know when they decide, and the checks of what they decided."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from covey.kernels.play.rules import NOBODY, State
from covey.model import InputError, LastCapture, Objective, PursuerDisk, Team
from covey.model.validation import Floats, Ints, frozen_array, read_only, shown
from covey.simulation.strategy import Chase, Fly, Situation

_NO_ROWS = np.empty(0, np.int64)


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
        team=Team(rows[:, :2], rows[:, 2], rows[:, 3], rows[:, 4]),
        disk=PursuerDisk(state.disk[:2], state.disk[2], disk.speed, disk.capture_radius),
        turns=read_only(state.turns[:alive].copy()),
        objective=objective,
    )


def pursuer_information(known_to_team: Situation, state: State, *, moves: bool) -> Situation:
    """Return what the pursuer knows: also the new turns and, if it `moves`, its position.

    In a game that began with a disk, a visible pursuer has no position before it first moves.
    """
    has_position = moves and state.pursuer[2] == 0.0
    return replace(
        known_to_team,
        turns=read_only(state.turns[: len(known_to_team.turns)].copy()),
        place=read_only(state.pursuer[:2].copy()) if has_position else None,
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


def checked_decision(
    decision: object, living: Sequence[int], disk: PursuerDisk, *, moves: bool
) -> tuple[Ints, int, tuple[float, float]]:
    """Return what the pursuer decided: its sequence, its target, its velocity.

    The sequence is in rows of the living. The target is a row, or `NOBODY`; then the velocity
    counts. A pursuer that doesn't move is a disk, and its velocity must be 0.
    """
    if isinstance(decision, Chase):
        rows = _chosen_rows(decision, living)
        return rows, int(rows[0]), (0.0, 0.0)
    if isinstance(decision, Fly):
        return _NO_ROWS, NOBODY, _chosen_velocity(decision, disk, moves=moves)
    raise InputError(f"pursuer's decision: expected Chase or Fly, got {shown(decision)}")


def _chosen_rows(chase: Chase, living: Sequence[int]) -> Ints:
    sequence = list(chase.sequence)
    if not sequence or len(set(sequence)) < len(sequence) or not set(sequence) <= set(living):
        raise InputError(
            f"Chase: expected a sequence of living evaders {list(living)}, got {shown(sequence)}"
        )
    return np.array([living.index(i) for i in sequence], dtype=np.int64)


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
