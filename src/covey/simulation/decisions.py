"""The border between strategies and rules: what a strategy decided is checked here."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from covey.model import InputError, PursuerDisk
from covey.model.checks import Floats, Ints, frozen_array
from covey.simulation.strategy import Chase, Fly


def checked_turns(turns: object, alive: int) -> Floats:
    """Return what the team decided, (alive,) turns in [-π, π]."""
    checked = frozen_array("turns returned by the team's strategy", turns, (alive,))
    if np.abs(checked).max() > math.pi:
        raise InputError(
            f"turns returned by the team's strategy: expected radians in [-π, π], "
            f"got {checked.tolist()}"
        )
    return checked


def chosen_rows(chase: Chase, living: Sequence[int]) -> Ints:
    """Return whom a pursuer makes for, as rows of the living, at least one."""
    sequence = list(chase.sequence)
    if not sequence or len(set(sequence)) < len(sequence) or not set(sequence) <= set(living):
        raise InputError(
            f"Chase: expected a sequence of living evaders {list(living)}, got {sequence}"
        )
    return np.array([living.index(i) for i in sequence], dtype=np.int64)


def chosen_velocity(decision: object, disk: PursuerDisk, *, shapeless: bool) -> tuple[float, float]:
    """Return the velocity that a pursuer chose; a `shapeless` one, its disk, can only wait."""
    if not isinstance(decision, Fly):
        # A hidden pursuer that is flown comes here with a Chase, too.
        wanted = "Fly" if isinstance(decision, Chase) else "Chase or Fly"
        raise InputError(f"pursuer's decision: expected {wanted}, got {decision!r}")
    velocity = frozen_array("Fly.velocity", decision.velocity, (2,))
    speed = float(np.hypot(*velocity))
    if speed > disk.speed * (1.0 + 1e-12):
        raise InputError(f"Fly: expected a speed of at most {disk.speed:g}, got {speed:g}")
    if shapeless and speed > 0.0:
        raise InputError(
            "Fly: a hidden pursuer is known as a disk only and can't be steered; "
            "return Chase((...)) to name its next target, or Fly() to wait"
        )
    return float(velocity[0]), float(velocity[1])
