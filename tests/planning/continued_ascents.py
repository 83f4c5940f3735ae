"""Going on from where an ascent ended."""

from __future__ import annotations

import covey

RAISED_AT_MOST = 1e-8
"""Of the survival time, relative: an ascent ends where a step promises less than 1e-9."""


def ascent(team, disk, start):
    """One ascent from a plan, with its sequences, or from bare turns."""
    return covey.plan(team, disk, starts=1, warm_start=start)


def allowed(plan):
    return plan.survival_time * (1.0 + RAISED_AT_MOST)


def assert_cannot_be_continued(team, disk, plan):
    """Not with its own sequences, nor from the bare turns."""
    assert ascent(team, disk, plan).survival_time <= allowed(plan)
    assert ascent(team, disk, plan.turns).survival_time <= allowed(plan)
