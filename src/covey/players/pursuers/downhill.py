"""A pursuer of two evaders that descends the true value of their game."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.bounds import TwoEvaderValue
from covey.model.angles import unit_vectors
from covey.planning import capture_times
from covey.simulation import Chase, Fly, PursuerPolicy, Situation

_BEARINGS = 32
_AHEAD = 0.02
"""Length of the look-ahead, as a share of the value and of the time to the nearer evader."""

_WORTH_CHASING = 1e-4
"""Chases are exact: preferred up to this loss of value, as a share of the step's time."""


@dataclass(frozen=True, eq=False)
class DownhillPursuer:
    """Fly where the value falls fastest, as the evaders fly what they have announced.

    For two evaders with unlimited turn rates and a pursuer that they see. Where both evaders are
    equally good as first targets, the pursuer flies between them and so hides its order.

    Parameters
    ----------
    value
        The value for the evaders' speeds, see `covey.bounds.solve_two_evaders`.
    """

    value: TwoEvaderValue

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters."""
        return {"name": "downhill", "cells": len(self.value.shares) - 1}

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        return self._decide

    def _decide(self, situation: Situation) -> Chase | Fly:
        team, pursuer = situation.team, situation.pursuer
        speed = pursuer.speed
        if len(team) == 1:
            return Chase(situation.evaders)
        now = self.value.of(team, pursuer)
        off = team.positions - pursuer.center
        goals = team.headings + situation.turns
        flights = team.speeds[:, np.newaxis] * unit_vectors(goals)
        nearest = float(np.hypot(off[:, 0], off[:, 1]).min()) / speed
        step = _AHEAD * min(now, nearest)
        chases = np.array([_bearing_to(situation, row) for row in (0, 1)])
        bearings = np.linspace(-math.pi, math.pi, _BEARINGS, endpoint=False)
        velocities = speed * unit_vectors(np.concatenate([chases, bearings]))
        after = self.value.at(off + step * (flights - velocities[:, np.newaxis]))
        best, chased = int(after.argmin()), int(after[:2].argmin())
        if after[chased] <= after[best] + _WORTH_CHASING * step * speed:
            first = situation.evaders[chased]
            return Chase((first, *(i for i in situation.evaders if i != first)))
        return Fly((float(velocities[best, 0]), float(velocities[best, 1])))


def _bearing_to(situation: Situation, row: int) -> float:
    """Return the bearing under which an evader is met on its announced flight."""
    team, disk = situation.team, situation.pursuer
    time = capture_times(team, disk, situation.turns, [row, 1 - row])[0]
    heading = team.headings[row] + situation.turns[row]
    off = team.positions[row] - disk.center
    x, y = off + team.speeds[row] * time * unit_vectors(heading)
    return math.atan2(y, x)
