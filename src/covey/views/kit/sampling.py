"""Points along lines: cameras and labels must know where something is drawn."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from covey.model.angles import unit_vectors
from covey.model.validation import Floats

_SAMPLES = 40
"""Points along a straight piece: closer together than the letters of a label are high."""
_WEIGHT = 10
"""Points of a line that a label hides rather than a marker."""


def joined(paths: Iterable[Floats]) -> Floats:
    """All points of some paths, (K, 2)."""
    return np.concatenate([np.reshape(path, (-1, 2)) for path in paths])


def rim(center: Floats, radius: float) -> Floats:
    """Points (K, 2) along the rim of a disk."""
    return center + radius * unit_vectors(np.linspace(0.0, math.tau, _SAMPLES))


def marked(points: Floats) -> Floats:
    """Points (K, 2) of markers, each several times, so that labels hide lines rather than them."""
    return np.repeat(np.reshape(points, (-1, 2)), _WEIGHT, axis=0)


def sampled(corners: Floats) -> Floats:
    """Points (K, 2) along the straight pieces between `corners` (M, 2)."""
    numbers = np.arange(len(corners))
    samples = np.linspace(0.0, len(corners) - 1.0, _SAMPLES * max(1, len(corners) - 1))
    return np.column_stack([np.interp(samples, numbers, corners[:, axis]) for axis in (0, 1)])
