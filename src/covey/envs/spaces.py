"""Gymnasium spaces of observations and actions."""

from __future__ import annotations

import math

import numpy as np
from gymnasium.spaces import Box

from covey.envs.setup import Setup
from covey.kernels.play.observation import DISK, ROW


def observation_space(setup: Setup) -> Box:
    """Return the space (6N + 3,) of every agent's observation; see `covey.envs.pursuit_v0`."""
    # No two players are farther apart: opposite corners, and flights until the time limit.
    length = math.sqrt(2.0) * setup.side + 2.0 * setup.disk_radius + setup.capture_radius
    length += (setup.pursuer_speed + setup.fastest) * setup.time_limit
    row = [length, length, setup.fastest, setup.fastest, math.pi, 1.0]
    high = np.array(row * setup.team_size + [length] * DISK, dtype=np.float32)
    low = -high
    low[ROW - 1 : -DISK : ROW] = 0.0
    low[-1] = 0.0
    return Box(low, high, dtype=np.float32)


def direction_space() -> Box:
    """Return the space of the pursuer's action, its direction (2,)."""
    return Box(-1.0, 1.0, (2,), np.float32)


def steering_space(count: int) -> Box:
    """Return the space of the turn rates (`count`,) of evaders, shares of the largest."""
    return Box(-1.0, 1.0, (count,), np.float32)
