"""The fixed-sequence problem: the best flight of a team that knows the order of capture."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from covey.bounds.root_search import root_near
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.maximum.fixed_sequence import latest_in_sequence, new_grids
from covey.model import PursuerDisk, Team
from covey.model.angles import wrap_angle
from covey.model.validation import Floats, Ints, permutation, read_only
from covey.planning.guarantee import capture_times, pursuit_of

_TURN_TOLERANCE = 1e-9
"""Radians. The last capture is a maximum, so it errs by the square of this."""

_NEAR_ROOT = 1e-3
"""Radians. So near to the maximum a root search takes over where turning is unlimited."""


class SequenceStatus(StrEnum):
    """How the search for a flight against a known sequence ended."""

    CONVERGED = "the best turns of a grid, refined until they stood still"
    STEPS_USED_UP = "the turns were still moving when the refinements were used up"


@dataclass(frozen=True, eq=False)
class SequencePlan:
    """The plan for a pursuer that has announced its capture sequence and keeps to it.

    Attributes
    ----------
    sequence : tuple of int
        The order of capture.
    turns : numpy.ndarray
        (N,) signed turns δ in [-π, π], radians, by evader.
    goal_headings : numpy.ndarray
        (N,) headings φ after the turn, radians in [-π, π], by evader.
    capture_times : numpy.ndarray
        (N,) least capture times in the order of `sequence`.
    survival_time : float
        The last of them: max over the turns of f_s.
    status : SequenceStatus
    """

    sequence: tuple[int, ...]
    turns: Floats
    goal_headings: Floats
    capture_times: Floats
    survival_time: float
    status: SequenceStatus


def plan_for_sequence(team: Team, disk: PursuerDisk, sequence: npt.ArrayLike) -> SequencePlan:
    """Find the turns with the latest last capture in one known capture sequence.

    Parameters
    ----------
    team, disk
        The state of the game: any number of evaders, each slower than the pursuer.
    sequence
        (N,) each evader 0..N-1 once.

    Returns
    -------
    SequencePlan
        Where several turns are equally good, the smallest on the grid; compare survival times,
        never headings.

    Raises
    ------
    InputError
        If `sequence` isn't a permutation or an evader is as fast as the pursuer.

    Notes
    -----
    There are several local maxima: an evader that stands between the pursuer and the next one can
    dodge to either side. So the search is global: a later capture on the same path delays all
    others, hence a dynamic programme over one turn at a time is exact on a grid of turns, 65 for
    each evader. Grids around the best turns then refine them. Two maxima that the first grid can't
    tell apart, their values differing by less than its spacing's square, may be confused;
    `covey.bracket` excludes that by a bound, which found no such case in 700 random games.

    With unlimited turn rates straight flight is optimal, and the turns solve the root-searching
    problem of [2]_: with T_k the k-th capture time, P_k its place, n_k the unit vector from P_{k-1}
    to P_k and λ_k = dT_N/dT_k as far as it is delayed by the k-th flight alone, the k-th evader
    flies along λ_k n_k - λ_{k+1} n_{k+1}, the last one straight away from P_{N-1}. Such a root may
    also be a minimum or a saddle, so the grid says near which one to search; the root search then
    gives the turns to the last digits. Comparing times tells them to some 1e-8 only.

    References
    ----------
    .. [1] A. A. Chikrii, L. A. Sobolenko, S. F. Kalashnikova, "A numerical method for the solution
       of the successive pursuit-and-evasion problem", Cybernetics 24 (1988).
    .. [2] A. Belousov, Y. Berdyshev, A. Chentsov, A. Chikrii, "Solving the dynamic traveling
       salesman game problem", Cybernetics and Systems Analysis 46 (2010).
    """
    disk.require_faster_than(team)
    order = permutation("sequence", sequence, len(team))
    found, settled = _latest(team, pursuit_of(disk), order)
    turns = np.where(np.isinf(team.turn_rates), wrap_angle(found), found)
    goals, times = wrap_angle(team.headings + turns), capture_times(team, disk, turns, order)
    return SequencePlan(
        sequence=tuple(order.tolist()),
        turns=read_only(turns),
        goal_headings=read_only(goals),
        capture_times=read_only(times),
        survival_time=float(times[-1]),
        status=SequenceStatus.CONVERGED if settled else SequenceStatus.STEPS_USED_UP,
    )


def _latest(team: Team, pursuit: Pursuit, order: Ints) -> tuple[Floats, bool]:
    """Return the best turns, and whether they stand still."""
    evaders = team.as_rows()
    if np.isinf(team.turn_rates).all():
        near, _ = _closed_in(evaders, pursuit, order, _NEAR_ROOT)
        root = root_near(evaders, pursuit, order, near)
        if root is not None:
            return root, True
    return _closed_in(evaders, pursuit, order, _TURN_TOLERANCE)


def _closed_in(
    evaders: Floats, pursuit: Pursuit, order: Ints, tolerance: float
) -> tuple[Floats, bool]:
    """Return the best turns on ever finer grids, and whether they are known to the tolerance."""
    turns = np.zeros(len(order))
    settled = latest_in_sequence(pursuit, order, tolerance, new_grids(evaders), turns)
    return turns, settled
