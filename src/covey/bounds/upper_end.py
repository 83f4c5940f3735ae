"""What no team can exceed: a pursuer that announces its sequence, and how it best begins."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from covey.bounds.announced_sequence import announcements
from covey.bounds.fixed_sequence import SequencePlan, plan_for_sequence
from covey.bounds.polygon_bound import (
    DENSE,
    SPARSE,
    Opening,
    Spacing,
    bound_near,
    first_capture,
    opening_towards,
)
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats

_MAX_IMPROVEMENTS = 8
"""Improvements of the pursuer's start in its disk, at most."""

_FINALISTS = 2
"""Sequences, the best against the team's own turn limits, whose proven bounds are compared."""

OPENINGS = (0.0, 0.35, 0.65, 0.8, 0.9)
"""Times of the opening flights that are compared, over the time of the first capture expected."""


_FASTEST = 0.9999
"""Share of the pursuer's speed up to which turn limits count: polygons for faster evaders have
thousands of corners."""


class UpperEnd(NamedTuple):
    """A time by which a pursuer has captured everybody, whatever the team does, and how."""

    time: float
    sequence: tuple[int, ...]
    start: Floats  # (2,) where it starts in its disk
    needs_limits: bool  # whether it holds only for evaders with the team's turn rates


class _Candidate(NamedTuple):
    """A sequence, the team's answer to it, and how the pursuer begins."""

    plan: SequencePlan
    disk: PursuerDisk  # where it starts: a point
    opening: Opening


def earliest_end(
    team: Team,
    disk: PursuerDisk,
    *,
    known: Iterable[tuple[int, ...]] = (),
    openings: tuple[float, ...] = OPENINGS,
) -> UpperEnd:
    """Return the earlier of two ends: for evaders that turn at once, and with their turn rates.

    Parameters
    ----------
    team, disk
        The state of the game, in a frame whose origin is near the disk's centre.
    known
        Sequences that are compared with those that the search visits.
    openings
        The second pursuer begins with a straight flight towards the first capture that it expects,
        for the best of these shares of that capture's time. Without any there is no second pursuer.
    """
    agile = Team(team.positions, team.headings, team.speeds, math.inf)
    end = _best(agile, disk, announcements(agile, _without_reach(disk), known)[:1], (0.0,))
    fastest = float(team.speeds.max())
    if not openings or np.isinf(team.turn_rates).all() or fastest > _FASTEST * disk.speed:
        return end
    plans = announcements(team, _without_reach(disk), known)[:_FINALISTS]
    limited = _best(team, disk, plans, openings)
    return limited._replace(needs_limits=True) if limited.time < end.time else end


def _best(
    team: Team, disk: PursuerDisk, plans: Iterable[SequencePlan], openings: tuple[float, ...]
) -> UpperEnd:
    """Return the earliest proven end over plans and openings, as one that needs no turn limits."""
    candidates = [
        _Candidate(
            plan, start, opening_towards(team, start, plan, share * float(plan.capture_times[0]))
        )
        for start, plan in (_from_best_start(team, disk, plan) for plan in plans)
        for share in openings
    ]
    if len(candidates) > 1:
        candidates = [min(candidates, key=lambda each: _bound(team, each, SPARSE))]
    best = candidates[0]
    time = _bound(team, best, DENSE)
    return UpperEnd(time, best.plan.sequence, best.disk.center, needs_limits=False)


def _bound(team: Team, candidate: _Candidate, spacing: Spacing) -> float:
    plan, disk, opening = candidate
    return bound_near(team, disk, plan.sequence, plan.goal_headings, spacing, opening)[0]


def _without_reach(disk: PursuerDisk) -> PursuerDisk:
    return PursuerDisk(disk.center, disk.radius, disk.speed)


def _from_best_start(
    team: Team, disk: PursuerDisk, announced: SequencePlan
) -> tuple[PursuerDisk, SequencePlan]:
    """Return the pursuer at a good position in its disk, and the team's best answer.

    The pursuer moves to the point nearest to the first capture and the team answers, until the last
    capture comes no earlier.
    """
    best: tuple[PursuerDisk, SequencePlan] | None = None
    for _ in range(_MAX_IMPROVEMENTS):
        goal = first_capture(team, disk, announced)
        start = PursuerDisk(disk.nearest_point(goal), 0.0, disk.speed, disk.capture_radius)
        announced = plan_for_sequence(team, _without_reach(start), announced.sequence)
        if best is not None and announced.survival_time >= best[1].survival_time:
            break
        best = start, announced
    assert best is not None
    return best
