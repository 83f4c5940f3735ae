"""Angles: radians, counter-clockwise from +x."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from covey.model.team import Team
from covey.model.validation import Floats, frozen_array, require_kind


def wrap_angle(angle: npt.ArrayLike) -> Floats:
    """Return `angle` (any shape, radians) as the same direction in [-π, π]."""
    return np.remainder(np.asarray(angle, dtype=np.float64) + math.pi, 2 * math.pi) - math.pi


def unit_vectors(angles: npt.ArrayLike) -> Floats:
    """Return the unit vectors (..., 2) along `angles` (any shape, radians)."""
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def away_from(center: npt.ArrayLike, positions: npt.ArrayLike) -> Floats:
    """Return the headings (...), radians, straight away from `center` (2,) at `positions` (..., 2).

    At the centre itself every heading leads away; there the result is 0 or ±π.
    """
    offsets = np.asarray(positions, dtype=np.float64) - np.asarray(center, dtype=np.float64)
    headings: Floats = np.arctan2(offsets[..., 1], offsets[..., 0])
    return headings


def turns_to(team: Team, goal_headings: npt.ArrayLike) -> Floats:
    """Signed turns δ that bring each evader to a goal heading φ the shorter way.

    Parameters
    ----------
    team
        N evaders.
    goal_headings
        (N,), radians.

    Returns
    -------
    numpy.ndarray
        (N,), radians in [-π, π], positive counter-clockwise. A half turn comes as -π: a goal
        heading alone doesn't say which way to make it.

    Raises
    ------
    InputError
        If the headings are not N finite numbers.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> covey.turns_to(team, [0.5, 1.5, -1.4]).round(3).tolist()
    [0.2, -0.5, 0.0]
    """
    require_kind("team", team, Team)
    goals = frozen_array("goal_headings", goal_headings, (len(team),))
    return wrap_angle(goals - team.headings)
