"""What a contingent plan guarantees against a pursuer that may put each capture off."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from covey.kernels.arrays import Workspace
from covey.kernels.contingent.delays import (
    INTERVAL,
    MOST,
    PUT_OFF,
    VISITED,
    DelaySearch,
    survives_delays,
)
from covey.kernels.contingent.minimum import TIME, new_levels
from covey.kernels.contingent.tree import Tree, answer_to
from covey.model.display import html_row, one_line, quantity
from covey.model.units import titled, units_with
from covey.planning.contingent.moment import Moment, after_capture
from covey.planning.contingent.search import problem_of
from covey.planning.long_calls import interceptions_of_minimum, interruptible

RESOLUTION = 1e-3
"""Relative, of the least over all delays; larger where the search would take too long."""

_FINEST = 0.03  # drift of the shortest intervals at first, over the resolution, as a length
_FINER, _COARSER = 0.25, 4.0
_FINEST_SHARE = 1e-4
_MOST_NODES = 1_000_000


@dataclass(frozen=True)
class DelayedGuarantee:
    """A survival time that holds whenever the captures happen.

    Attributes
    ----------
    survival_time : float
        Guaranteed, however late the pursuer makes each capture.
    resolution : float
        The least over all delays lies between `survival_time` and this much above.
    unit : str
        Of the team's lengths; with one, both times are in seconds.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> tree = covey.plan_contingent(team, disk)
    >>> tree.with_delays.survival_time <= tree.survival_time
    True
    """

    survival_time: float
    resolution: float
    unit: str = ""

    def __repr__(self) -> str:
        """Return both numbers in one line."""
        second = units_with(self.unit).time
        return one_line(
            "DelayedGuarantee",
            survival_time=quantity(self.survival_time, second),
            resolution=quantity(self.resolution, second),
        )

    def _repr_html_(self) -> str:
        second = units_with(self.unit).time
        facts = {
            titled("survival time", second): self.survival_time,
            titled("resolution", second): self.resolution,
        }
        return html_row("DelayedGuarantee", facts)


def with_delays(
    moment: Moment, tree: Tree, survival_time: float, unit: str = ""
) -> DelayedGuarantee:
    """Return what a tree guarantees with delays; without, it guarantees the given time.

    The certified search of `kernels.contingent.delays`, for targets below the earliest end of a
    play that is known. Where all plays end after a target, it is guaranteed; the next target is
    halfway to the earliest end. Where the search stops at a play that ends earlier, that end is
    known from then on, and the next target is twice as far below it. Where this play ends no
    earlier, the intervals were too long.
    """
    n = len(moment.evaders)
    problem, search = problem_of(moment), _new_search(n)
    work = _MOST_NODES * interceptions_of_minimum(n, False)
    guaranteed, earliest = 0.0, survival_time
    step = resolution = RESOLUTION
    finer = 1.0
    while resolution < 1.0 and guaranteed < earliest * (1.0 - resolution):
        below = max(earliest * (1.0 - step), 0.5 * (guaranteed + earliest))
        target = min(below, earliest * (1.0 - resolution))
        finest = _FINEST * finer * (earliest - target) * moment.pursuit.speed
        wanted = search._replace(target=target, finest=finest)

        def is_survived(scratch: Workspace, wanted: DelaySearch = wanted) -> bool:
            return survives_delays(problem, tree, wanted, scratch)

        if interruptible(is_survived, n, False, work):
            guaranteed = target
            continue
        end = _end_of_play(moment, tree, search)
        if end < earliest * (1.0 - 1e-9):
            earliest, step = end, 2.0 * step
        elif search.counters[VISITED] > search.counters[MOST] or finer < _FINEST_SHARE:
            resolution, finer = _COARSER * resolution, 1.0
        else:
            finer *= _FINER
    return DelayedGuarantee(guaranteed, earliest - guaranteed, unit)


def _new_search(n: int) -> DelaySearch:
    worst, counters = np.empty(n, np.int64), np.array([0, _MOST_NODES, 0])
    return DelaySearch(0.0, 0.0, new_levels(n), np.empty((n, INTERVAL)), worst, counters)


def _end_of_play(moment: Moment, tree: Tree, search: DelaySearch) -> float:
    """Return when the play ends at which a search stopped.

    Each capture happens as early as it can, but not before the time that the search has for it.
    """
    put_off = int(search.counters[PUT_OFF])
    times = search.levels.disks[1 : put_off + 1, TIME].tolist()
    turns, depth, now, left = tree.turns, tree.depth, 0.0, list(range(len(moment.evaders)))
    for k, i in enumerate(search.worst.tolist()):
        rank, own = left.index(i), turns[: len(left)]
        time = float(moment.earliest(own)[rank])
        if k < put_off:
            time = max(time, times[k] - now)
        now += time
        if len(left) > 1:
            moment, rest = after_capture(moment, own, rank, time)
            turns = answer_to(turns, len(left), rank) if k < depth else rest
            left.remove(i)
    return now
