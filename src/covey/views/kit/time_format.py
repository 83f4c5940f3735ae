"""Times as text, all of a picture with the same number of decimals."""

from __future__ import annotations

import math
from collections.abc import Callable


def clock(longest: float) -> Callable[[float], str]:
    """Return what writes times up to `longest`: three digits of the longest, as many of each."""
    if not 1e-3 <= longest < 1e5:
        return lambda time: f"{time:.3g}"
    decimals = max(0, 2 - math.floor(math.log10(longest)))
    return lambda time: f"{time:.{decimals}f}"
