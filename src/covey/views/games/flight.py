"""Where a plan takes the evaders: paths of the kernels, sampled for drawing."""

from __future__ import annotations

import numpy as np

from covey.kernels.capture.path import PATH, sample, set_paths
from covey.model import Team
from covey.model.validation import Floats, Ints

_SAMPLES = 80
"""Points of a drawn path: enough that a full turn shows no corners."""


def positions_at(team: Team, turns: Floats, times: Floats) -> Floats:
    """Positions (K, N, 2) of a team that makes `turns` (N,), at `times` (K,) from now."""
    paths = np.empty((len(team), PATH))
    any_speed = 1.0  # of the pursuer: the evaders' positions don't depend on it
    set_paths(team.as_rows(), turns, any_speed, paths)
    sampled = np.empty((len(times), len(team), 2))
    sample(paths, times, sampled)
    return sampled


def path(team: Team, turns: Floats, evader: int, end: float) -> Floats:
    """Points (K, 2) along the path of one evader, from now to the time `end`."""
    alone = np.array([evader])
    return positions_at(subteam(team, alone), turns[alone], np.linspace(0.0, end, _SAMPLES))[:, 0]


def advance(team: Team, turns: Floats, elapsed: float) -> tuple[Team, Floats]:
    """The team after it has flown its plan for `elapsed`, and the turns (N,) that remain."""
    with np.errstate(invalid="ignore"):  # inf * 0: an unlimited turn is made at time 0
        turned = np.copysign(np.fmin(np.abs(turns), team.turn_rates * elapsed), turns)
    positions = positions_at(team, turns, np.array([elapsed]))[0]
    return Team(positions, team.headings + turned, team.speeds, team.turn_rates), turns - turned


def subteam(team: Team, evaders: Ints) -> Team:
    """Some of the evaders, in a given order."""
    columns = (team.positions, team.headings, team.speeds, team.turn_rates)
    return Team(*(column[evaders] for column in columns))
