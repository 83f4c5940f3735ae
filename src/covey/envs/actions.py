"""From actions, checked, to turn rates and velocities."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from covey.model import InputError
from covey.model.validation import Floats, frozen_array


def shares_of(name: str, action: npt.ArrayLike, shape: tuple[int, ...]) -> Floats:
    """Return turn rates as shares of the largest; InputError if one is outside of [-1, 1]."""
    shares = frozen_array(name, action, shape)
    if np.abs(shares).max() > 1.0:
        raise InputError(f"{name}: expected turn rates in [-1, 1], got {shares.tolist()}")
    return shares


def velocities_of(name: str, action: npt.ArrayLike, shape: tuple[int, int], speed: float) -> Floats:
    """Return velocities (K, 2) in the directions (K, 2) of an action; (0, 0) stays (0, 0)."""
    directions = frozen_array(name, action, shape)
    lengths = np.hypot(directions[:, :1], directions[:, 1:])
    lengths[lengths == 0.0] = 1.0
    return speed * (directions / lengths)


def velocity_of(name: str, action: npt.ArrayLike, speed: float) -> tuple[float, float]:
    """Return the velocity in the direction (2,) of an action; (0, 0) stays (0, 0)."""
    direction = frozen_array(name, action, (2,))
    x, y = velocities_of(name, direction[None], (1, 2), speed)[0].tolist()
    return x, y
