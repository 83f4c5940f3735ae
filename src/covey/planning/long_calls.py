"""Long calls of kernels, which an interrupt or a deadline ends early.

Python serves a signal between two instructions of the main thread, so never inside a kernel. Long
calls therefore run in other threads, while the calling thread waits where Python can serve signals.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import TypeVar

import numpy as np

from covey.kernels.arrays import FEWEST_WALKING, GO_ON, Workspace
from covey.kernels.maximum.objective import Objective
from covey.model.validation import Ints
from covey.planning.threads import Threads
from covey.planning.workspace import workspace

Result = TypeVar("Result")

LONG = 1e7
"""Interceptions that take about a tenth of a second: a call with more of them is long."""

_SUM = 10.0
"""Interceptions of a minimum of sums over those of a minimum of the last capture, about."""


def interceptions_of(objective: Objective, n: int) -> float:
    """Return about how many interceptions one value of an objective of n evaders takes."""
    if objective.expected:
        return float(n * objective.draws.used[0])
    return interceptions_of_minimum(n, objective.total)


def interceptions_of_minimum(n: int, total: bool) -> float:
    """Return the same of a minimum of the last capture or, with `total`, of the sum."""
    if total:
        return _SUM * n * 2.0**n
    return n * 2.0 ** (n if n <= FEWEST_WALKING else FEWEST_WALKING + (n - FEWEST_WALKING) / 4)


def interruptible(
    call: Callable[[Workspace], Result],
    size: int,
    total: bool,
    interceptions: float,
    deadline: float = math.inf,
) -> Result:
    """Return the result of a call that takes a workspace.

    Parameters
    ----------
    call
        Makes a call of a kernel that reads `Workspace.stop`.
    size, total
        As for `workspace`.
    interceptions
        How many the call computes, about. A long call runs in another thread.
    deadline
        As for `Threads.run`.
    """
    if deadline == math.inf and interceptions <= LONG:
        return call(workspace(size, total))
    stop = new_flag()
    with Threads(1) as threads:
        return threads.run([lambda: call(workspace(size, total, stop))], stop, deadline)[0]


def new_flag() -> Ints:
    """Return the flag of a call, (1,), see `Workspace.stop`."""
    return np.full(1, GO_ON)


def deadline_after(time_limit: float | None) -> float:
    """Return the moment so many seconds from now, by `time.perf_counter`; None: inf."""
    return math.inf if time_limit is None else time.perf_counter() + time_limit
