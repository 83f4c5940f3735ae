"""Where a plan takes the evaders: paths of the kernels, sampled for drawing."""

from __future__ import annotations

import numpy as np

from covey.kernels.capture.path import sample
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.planning.border import paths_of

_SAMPLES = 80
"""Points of a drawn path: enough that a full turn shows no corners."""


def positions_at(team: Team, turns: Floats, times: Floats) -> Floats:
    """Positions (K, N, 2) of a team that makes `turns` (N,), at `times` (K,) from now."""
    any_disk = PursuerDisk()  # positions don't depend on the pursuer
    sampled = np.empty((len(times), len(team), 2))
    sample(paths_of(team, any_disk, turns), times, sampled)
    return sampled


def path(team: Team, turns: Floats, evader: int, end: float) -> Floats:
    """Points (K, 2) along the path of one evader, from now to the time `end`."""
    alone = np.array([evader])
    return positions_at(team.take(alone), turns[alone], np.linspace(0.0, end, _SAMPLES))[:, 0]


def advance(team: Team, turns: Floats, elapsed: float) -> tuple[Team, Floats]:
    """The team after it has flown its plan for `elapsed`, and the turns (N,) that remain."""
    with np.errstate(invalid="ignore"):  # inf * 0: an unlimited turn is made at time 0
        turned = np.copysign(np.fmin(np.abs(turns), team.turn_rates * elapsed), turns)
    positions = positions_at(team, turns, np.array([elapsed]))[0]
    return Team(positions, team.headings + turned, team.speeds, team.turn_rates), turns - turned
