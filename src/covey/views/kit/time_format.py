"""Times as text. All times of a picture have the same number of decimals."""

from __future__ import annotations

import math
from collections.abc import Callable

from covey.model.units import with_unit


def time_format(longest: float, unit: str = "") -> Callable[[float], str]:
    """Return a function that writes times, all with the decimals that give `longest` 3 digits."""
    if not 1e-3 <= longest < 1e5:
        return lambda time: with_unit(f"{time:.3g}", unit)
    decimals = max(0, 2 - math.floor(math.log10(longest)))
    return lambda time: with_unit(f"{time:.{decimals}f}", unit)
