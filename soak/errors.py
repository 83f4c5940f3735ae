"""By how much what came is off from what was to come: 0 where it isn't."""

from __future__ import annotations

import math

import numpy as np


def shortfall(promised, reached):
    """How far a value stays below what was promised, relative to that; NaN if one of them is."""
    if promised == 0.0 or reached >= promised:
        return 0.0
    return float((promised - reached) / promised)


def difference(one, other):
    """How far two values differ, relative to the larger one."""
    return abs(one - other) / max(one, other) if one != other else 0.0


def largest_fall(values):
    """The largest step down in a series."""
    return float(-np.diff(values).min(initial=0.0))


def exactly(condition):
    """Nothing where the condition holds, else infinity."""
    return 0.0 if condition else math.inf
