"""Points along lines: cameras and labels must know where something is drawn."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from covey.model.validation import Floats

_SAMPLES = 40
"""Points along a straight piece: closer together than the letters of a label are high."""


def joined(paths: Iterable[Floats]) -> Floats:
    """All points of some paths, (K, 2)."""
    return np.concatenate([np.reshape(path, (-1, 2)) for path in paths])


def sampled(corners: Floats) -> Floats:
    """Points (K, 2) along the straight pieces between `corners` (M, 2)."""
    numbers = np.arange(len(corners))
    samples = np.linspace(0.0, len(corners) - 1.0, _SAMPLES * max(1, len(corners) - 1))
    return np.column_stack([np.interp(samples, numbers, corners[:, axis]) for axis in (0, 1)])
