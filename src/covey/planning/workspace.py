"""The kernels' workspaces: memory that Python owns, kept from call to call, one set a thread.

Fresh pages of memory cost more than half of a guarantee for twelve evaders.
"""

from __future__ import annotations

import threading

from covey.kernels.arrays import (
    FEWEST_WALKING,
    SOLVED,
    STAGES_GIVEN,
    Workspace,
    new_workspace,
    stages_of_search,
)
from covey.kernels.contingent.scratch import TreeScratch, new_tree_scratch
from covey.kernels.minimum.total_time import MOST_FOR_SUMS
from covey.model import InputError
from covey.model.validation import Ints

SMALL = 14
"""Evaders up to which the workspaces of all sizes are kept: 6 MB, 16 MB with room for sums."""

LARGEST_KEPT = 18
"""Evaders up to which the last workspace with room for sums is kept: 210 MB. Without this room a
workspace takes at most 340 MB for a table and 310 MB for a large team, where they are used."""

_MOST_TREES = 16  # shapes of trees, of which the scratch is kept

_kept = threading.local()


def workspace(size: int, total: bool = False, stop: Ints | None = None) -> Workspace:
    """Return a workspace for teams of up to `size` evaders; with `total`, with room for sums.

    The next call with the same arguments in the same thread returns the same memory, so a workspace
    may be used for one call of a kernel at a time. With `stop` (1,), that is its flag, which ends
    long calls; otherwise nobody sets its flag.

    Raises
    ------
    InputError
        If the team is too large for sums.
    """
    if total and size > MOST_FOR_SUMS:
        raise InputError(
            f"team: expected at most {MOST_FOR_SUMS} evaders for a sum of survival times, got "
            f"{size}; its minimum over all capture sequences needs 40 N 2^N bytes, so split the "
            f"team, or plan for LastCapture()"
        )
    if stop is not None:
        return workspace(size, total)._replace(stop=stop)
    if total and size > LARGEST_KEPT:
        return new_workspace(size, total)
    kept: dict[tuple[int, bool], Workspace] = _kept.__dict__.setdefault("workspaces", {})
    if (size, total) not in kept:
        for large in [key for key in kept if min(key[0], size) > SMALL]:
            del kept[large]
        kept[size, total] = new_workspace(size, total)
    if size >= FEWEST_WALKING:  # results don't depend on the call before
        ints = kept[size, total].walks.ints
        ints[SOLVED], ints[STAGES_GIVEN] = 0, stages_of_search(size)
    return kept[size, total]


def tree_scratch(n: int, depth: int) -> TreeScratch:
    """Return the scratch of ascents on trees of n evaders, kept likewise."""
    kept: dict[tuple[int, int], TreeScratch] = _kept.__dict__.setdefault("trees", {})
    if (n, depth) not in kept:
        if len(kept) == _MOST_TREES:
            kept.clear()
        kept[n, depth] = new_tree_scratch(n, depth)
    return kept[n, depth]
