"""Whether a plan for a large team is worth what its search says, and what to do where it isn't.

A search gives each inner minimum up sooner than a guarantee does. So the guarantee may find a
sequence that the search has missed. Then the plan ascends again with this sequence.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from covey.kernels.maximum.working_set import add
from covey.model.validation import Floats
from covey.planning.guarantee import Guarantee
from covey.planning.multistart import Ascents, Search

_MOST_ASCENTS = 8
_REFUTED = 1e-9  # relative


def confirmed(
    search: Search, best: Ascents, guarantee_of: Callable[[Floats], Guarantee], deadline: float
) -> tuple[Ascents, Guarantee]:
    """Return a plan, ascended again while a sequence refutes its value, and its guarantee.

    Parameters
    ----------
    search, best
        The search, and its best plan, which is overwritten.
    guarantee_of
        Computes the guarantee of turns (N,).
    deadline
        By `time.perf_counter`, when no other ascent begins.
    """
    turns = best.iterate.turns
    guarantee = found = guarantee_of(turns)
    kept = turns.copy()
    for _ in range(_MOST_ASCENTS):
        if found.upper >= best.value * (1.0 - _REFUTED) or time.perf_counter() >= deadline:
            break
        add(best.iterate.working_set, np.array(found.sequence), best.iterate.working_set.values)
        again = search.refine(best.iterate)
        best = again._replace(
            starts=best.starts,
            steps=best.steps + again.steps,
            interceptions=best.interceptions + again.interceptions,
        )
        found = guarantee_of(turns)
        if found.time > guarantee.time:
            guarantee, kept = found, turns.copy()
    turns[:] = kept
    return best, guarantee
