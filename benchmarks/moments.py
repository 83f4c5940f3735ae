"""The games that are measured: the start of each, one update later, and what a method answers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

import covey
from covey.kernels.rules import NOBODY, Rules, announce, fly, initial_state

UPDATE_TIME = 0.01


class Moment(NamedTuple):
    """A game at its start, planned from flight straight away, and the same one update later.

    In between the visible pursuer has flown towards the first of the plan's worst sequence, and the
    evaders along their plan: what is left of it is where a warm replan starts.
    """

    team: covey.Team
    disk: covey.PursuerDisk
    away: np.ndarray  # (N,) turns to flight straight away
    plan: covey.Plan
    later_team: covey.Team
    later_disk: covey.PursuerDisk
    left: np.ndarray  # (N,) what is left of the plan's turns


class Answer(NamedTuple):
    """What a method took and reached on a moment."""

    seconds: float
    value: float
    settled: bool = True  # whether this planner, starting from there, finds nothing better


def moments(size):
    """Yield games as in section V of the paper: uniform in the unit square, headings away."""
    generator = np.random.default_rng(size)
    rules = Rules(1.0, 0.0, False, UPDATE_TIME, math.inf)
    disk = covey.PursuerDisk()
    while True:
        positions = generator.uniform(-0.5, 0.5, (size, 2))
        bearings = np.arctan2(positions[:, 1], positions[:, 0])
        team = covey.Team(positions, bearings)
        plan = covey.plan(team, disk, starts=1)
        state = initial_state(team.as_rows(), 0.0, 0.0, 0.0)
        state.turns[:] = plan.turns
        announce(state, rules)
        if fly(state, rules, plan.critical_sequences[0][0], 0.0, 0.0) == NOBODY:
            yield Moment(
                team,
                disk,
                covey.turns_to(team, bearings),
                plan,
                covey.Team(state.evaders[:, :2], state.evaders[:, 2]),
                covey.PursuerDisk(state.disk[:2]),
                state.turns.copy(),
            )
