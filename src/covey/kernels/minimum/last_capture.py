"""The exact minimum of the last capture over all sequences: Held and Karp's dynamic programme.

The pursuer is faster than every evader, so it can shadow an evader that it captured: being at a
capture earlier is never worse. So the earliest arrival for each (set of captured evaders, last
captured) is all that the rest of a sequence needs to know.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import ABANDON, Floats, Ints
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.straight_legs import set_lines
from covey.kernels.minimum.deadlines import set_deadlines
from covey.kernels.minimum.greedy_sequence import greedy_sequence
from covey.kernels.minimum.labels import (
    SubsetScratch,
    clear,
    extend,
    initial_labels,
    trace_back,
)

# Added to the time of a sequence, they make a bound that this sequence beats.
_SLACK, _LEAST = 1e-12, 1e-300


@compiled
def min_last_capture(
    paths: Floats, pursuit: Pursuit, bound: float, sequence: Ints, scratch: SubsetScratch
) -> tuple[float, int]:
    """Return the least time of a capture sequence of all evaders, if it is below `bound`.

    1. Without a bound, a greedy sequence gives one.
    2. Deadlines, backwards from the bound.
    3. Labels, forwards: sets in the order of their size, each label extended by each capture.
    4. The sequence is traced back from the least label of the full set.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    bound
        inf, or an upper bound such as the time of the worst sequence of a moment ago, which makes
        the search many times faster.
    sequence
        (n,) the order that attains the minimum; left alone where no sequence beats the bound.
        Modified in place.
    scratch
        With room for n evaders; modified in place.

    Returns
    -------
    float
        The minimum, or `bound` where no sequence beats it.
    int
        How many interceptions were computed.
    """
    n, labels = len(paths), scratch.labels
    if bound == math.inf:
        least = greedy_sequence(paths, pursuit, sequence, labels.arrivals)
        bound = least * (1.0 + _SLACK) + _LEAST
    set_lines(paths, scratch.lines)
    set_deadlines(paths, scratch.lines, pursuit, bound, scratch.deadlines)
    last_slot = initial_labels(paths, pursuit, bound, scratch)
    interceptions, slot, full = n, 1, (1 << n) - 1
    while slot <= last_slot and labels.queue[slot] != full and scratch.stop[0] != ABANDON:
        last_slot, cost = extend(paths, pursuit, bound, slot, last_slot, scratch)
        interceptions += cost
        slot += 1
    least = trace_back(paths, pursuit, bound, sequence, labels)
    clear(last_slot, labels)
    return least, interceptions
