"""How a committed pursuer keeps its sequence (section V.B)."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Ints, Workspace
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import capture_times, objective_value
from covey.kernels.maximum.multistart import search_scratch
from covey.kernels.minimum.inner_minimum import inner_minimum


class Commitment(NamedTuple):
    """How a pursuer keeps to a sequence."""

    margin: float  # relative gain for which it changes the sequence; inf: never
    sequence: Ints  # (N,) rows of the living; modified in place
    is_chosen: bool  # False: it begins with the best sequence, and `sequence` holds nothing


@compiled
def commit(
    paths: Floats,
    pursuit: Pursuit,
    total: bool,
    commitment: Commitment,
    workspace: Workspace,
) -> None:
    """Replace the pursuer's sequence where another sequence is better by more than the margin.

    Better is an earlier last capture or, with `total`, a smaller sum of capture times. The margin
    is relative to what the present sequence still comes to. A pursuer without a sequence takes the
    best. `paths` (n, PATH) are those of the living.
    """
    scratch = search_scratch(workspace).ascent
    n, bound = len(paths), math.inf
    sequence, times = commitment.sequence[:n], scratch.here.times[0, :n]
    if commitment.is_chosen:
        capture_times(paths, pursuit, sequence, times)
        bound = objective_value(times, total) * (1.0 - commitment.margin)
    if bound > 0.0:
        inner_minimum(paths, pursuit, total, bound, sequence, scratch.inner)
