"""How a committed pursuer keeps its sequence (section V.B)."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import entry
from covey.kernels.arrays import IntVector, Matrix, Workspace
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import capture_times, objective_value
from covey.kernels.minimum.inner_minimum import earlier_by_moves, inner_minimum, inner_scratch


class Commitment(NamedTuple):
    """How a pursuer keeps to a sequence."""

    margin: float  # relative gain for which it changes the sequence; inf: never
    sequence: IntVector  # (N,) rows of the living; modified in place
    is_chosen: bool  # False: it begins with the best sequence, and `sequence` holds nothing


@entry
def commit(
    paths: Matrix,
    pursuit: Pursuit,
    total: bool,
    commitment: Commitment,
    workspace: Workspace,
) -> None:
    """Replace the pursuer's sequence where another sequence is better by more than the margin.

    Better is an earlier last capture or, with `total`, a smaller sum of capture times. The margin
    is relative to what the present sequence still comes to. A pursuer without a sequence takes the
    best. Moves change the sequence against a team that is too large for an exact minimum at every
    update. `paths` (n, PATH) are those of the living.
    """
    scratch = inner_scratch(workspace)
    n, bound = len(paths), math.inf
    sequence, times = commitment.sequence[:n], scratch.times[:n]
    if commitment.is_chosen:
        capture_times(paths, pursuit, sequence, times)
        bound = objective_value(times, total) * (1.0 - commitment.margin)
    if commitment.is_chosen and n > scratch.largest_table:
        earlier_by_moves(paths, pursuit, sequence, bound, sequence, scratch)
    elif bound > 0.0:
        inner_minimum(paths, pursuit, total, bound, sequence, scratch)
