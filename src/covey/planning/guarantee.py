"""What a plan guarantees: the exact minimum over all capture sequences."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.kernels.arrays import (
    LARGEST_TABLE,
    STAGES_GIVEN,
    STAGES_OF_GUARANTEE,
    Workspace,
)
from covey.kernels.maximum.values import minimum_over_sequences
from covey.kernels.minimum.large.scratch import LOWER
from covey.model import (
    ExpectedSurvival,
    InputError,
    LastCapture,
    PursuerDisk,
    Team,
    TotalSurvival,
)
from covey.model.display import html_row, one_line, quantity
from covey.model.units import titled, units_with
from covey.model.validation import Floats, checked_array, number
from covey.planning.border import about_center, check_game, pursuit_of
from covey.planning.compiled_objective import checked_objective
from covey.planning.long_calls import deadline_after, interceptions_of_minimum, interruptible


@dataclass(frozen=True)
class Guarantee:
    """A guaranteed survival time, or sum of survival times, and the worst sequence known.

    Attributes
    ----------
    time : float
        No pursuer in the disk captures everybody earlier; for `TotalSurvival` no sum of all
        survival times is smaller. Always guaranteed.
    sequence : tuple of int
        A capture sequence that attains `upper`.
    upper : float
        What the sequence comes to; `time` where the guarantee is exact.
    unit : str
        Of the team's lengths; with one, both times are in seconds.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> worst = covey.guaranteed_survival(team, disk, covey.plan(team, disk).turns)
    >>> round(worst.time, 3)
    3.365
    """

    time: float
    sequence: tuple[int, ...]
    upper: float
    unit: str = ""

    @property
    def exact(self) -> bool:
        """Whether `time` is the exact minimum over all capture sequences."""
        return self.time == self.upper

    def __repr__(self) -> str:
        """Return both times and the sequence in one line."""
        second = units_with(self.unit).time
        return one_line(
            "Guarantee",
            time=quantity(self.time, second),
            upper=quantity(self.upper, second),
            sequence=self.sequence,
        )

    def _repr_html_(self) -> str:
        second = units_with(self.unit).time
        facts = {
            titled("time", second): self.time,
            titled("upper", second): self.upper,
            "sequence": self.sequence,
        }
        return html_row("Guarantee", facts)


def guaranteed_survival(
    team: Team,
    disk: PursuerDisk,
    turns: npt.ArrayLike,
    *,
    objective: LastCapture | TotalSurvival | str = LastCapture(),  # noqa: B008 frozen
    time_limit: float | None = None,
) -> Guarantee:
    """Survival time that a plan guarantees: the minimum over all capture sequences.

    Parameters
    ----------
    team, disk
        The state of the game; up to 50 evaders, for a sum up to 20.
    turns
        (N,) signed turns δ, radians.
    objective
        What is guaranteed: the last capture, or `TotalSurvival()`, the sum of all survival times;
        or the name of either in scenario files.
    time_limit
        Seconds after which the search for the worst sequence of more than 17 evaders ends with what
        it has proven. None: no limit.

    Returns
    -------
    Guarantee
        The time and the worst sequence. Exact for up to 20 evaders, and for most larger teams; else
        a proven lower bound, and a sequence that bounds it from above.

    Raises
    ------
    InputError
        If an argument has the wrong shape, an evader is as fast as the pursuer, or the team is too
        large.

    Notes
    -----
    The two inner minima of eq. (6), by dynamic programming over subsets (Held and Karp, 1962)
    instead of N! sequences; memory 16 N 2^N bytes. From eighteen evaders on only those subsets are
    kept that bounds from a relaxation don't rule out, docs/decisions/0016; up to 20 evaders all
    subsets follow where these bounds are too weak. Memory up to 310 MB, for 20 up to 660 MB. For
    the sum a state needs pairs of the time and the sum so far, docs/decisions/0009; memory
    40 N 2^N bytes.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> worst = covey.guaranteed_survival(team, disk, turns=[0.0, 0.0, 0.0])
    >>> round(worst.time, 3), worst.sequence
    (3.149, (1, 0, 2))
    """
    check_game(team, disk)
    if time_limit is not None:
        number("time_limit", time_limit, low=0.0)
    chosen = checked_objective(objective)
    if isinstance(chosen, ExpectedSurvival):
        raise InputError(
            "objective: expected LastCapture() or TotalSurvival(), got an expectation, which "
            "guarantees nothing; expected_survival computes it"
        )
    total = chosen.measure == "total"
    checked = checked_array("turns", turns, (len(team),))
    return worst_sequence(*about_center(team, disk), checked, total, deadline_after(time_limit))


def worst_sequence(
    team: Team, disk: PursuerDisk, turns: Floats, total: bool, deadline: float = math.inf
) -> Guarantee:
    """Return the guarantee of checked turns (N,); `total`: of the sum of all survival times.

    At the deadline the search for a large team ends with what it has proven.
    """
    n, evaders, pursuit = len(team), team.as_rows(), pursuit_of(disk)
    sequence = np.empty(n, np.int64)
    interceptions = interceptions_of_minimum(n, total)

    def least(scratch: Workspace) -> float:
        return minimum_over_sequences(evaders, turns, pursuit, total, math.inf, sequence, scratch)

    def bounds(scratch: Workspace) -> tuple[float, float]:
        scratch.walks.ints[STAGES_GIVEN] = STAGES_OF_GUARANTEE
        upper = least(scratch)
        return float(scratch.walks.floats[LOWER]), upper

    if total or n <= LARGEST_TABLE:
        lower = upper = interruptible(least, n, total, interceptions)
    else:
        lower, upper = interruptible(bounds, n, total, interceptions, deadline)
    return Guarantee(lower, tuple(sequence.tolist()), upper, team.unit)
