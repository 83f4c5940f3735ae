"""Going on from where an ascent ended, and looking around there."""

from __future__ import annotations

import math

import numpy as np

import covey
from kernels import calls

RAISED_AT_MOST = 1e-8
"""Of the survival time, relative: an ascent ends where a step promises less than 1e-9."""
CHANGES = (1e-4, 1e-3, 1e-2)
"""Radians."""


def ascent(team, disk, start):
    """One ascent from a plan, with its sequences, or from bare turns."""
    return covey.plan(team, disk, starts=1, warm_start=start)


def allowed(plan):
    return plan.survival_time * (1.0 + RAISED_AT_MOST)


def assert_cannot_be_continued(team, disk, plan, generator):
    """Not with its own sequences, nor from the bare turns but to another maximum.

    With its first step, of up to 0.2 rad, one ascent in a few thousand leaps there from bare turns:
    it knows none of the sequences that held the plan. Then nothing near the plan is better.
    """
    assert ascent(team, disk, plan).survival_time <= allowed(plan)
    if ascent(team, disk, plan.turns).survival_time > allowed(plan):
        assert_no_neighbour_better(team, disk, plan, generator)


def assert_no_neighbour_better(team, disk, plan, generator):
    for turns in neighbours(plan.turns, generator):
        inside = np.clip(turns, -math.pi, math.pi)
        assert calls.least(team, disk, inside)[0] <= allowed(plan)


def neighbours(turns, generator):
    """Turns with one changed, and with all changed."""
    n = len(turns)
    for size in CHANGES:
        for i in range(n):
            for side in (-1.0, 1.0):
                yield turns + side * size * np.eye(n)[i]
        for _ in range(60):
            yield turns + generator.uniform(-size, size, n)
            yield turns + generator.choice([-size, size], n)
