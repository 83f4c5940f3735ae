"""Array types of the kernels' arguments, and the pursuer as they see it.

Kernels index tables as `table[i, COLUMN]`. A row taken as an array of its own (`table[i]`) is
counted by the memory manager, which made an interception five times slower.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Table = npt.NDArray[np.float64]


class Pursuit(NamedTuple):
    """A pursuer that is somewhere in a disk and captures within a distance.

    `first_radius` is r + ρ: from anywhere in the disk the first capture happens within ρ.
    `later_radius` is 2ρ: after a capture at x_j the pursuer is within ρ of x_j, and captures the
    next one within ρ.
    """

    center_x: float
    center_y: float
    first_radius: float
    later_radius: float
    speed: float
