"""The fixed-sequence problem: the best plan of a team that knows the capture sequence."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from covey.bounds.root_search import root_near
from covey.kernels.bounds.fixed_sequence import latest_in_sequence, new_grids
from covey.kernels.capture.pursuit import Pursuit
from covey.model import PursuerDisk, Team
from covey.model.angles import wrap_angle
from covey.model.display import html_table, one_line, quantity
from covey.model.units import titled, units_with
from covey.model.validation import Floats, Ints, permutation, read_only
from covey.model.value import Value
from covey.planning.border import about_center, check_players, pursuit_of
from covey.planning.one_sequence import capture_times

_TURN_TOLERANCE = 1e-9
"""Radians. At a maximum an error of the turns changes the last capture by its square."""

_ROOT_SEARCH_FROM = 1e-3
"""Radians from the maximum at which a root search takes over, for unlimited turn rates."""


class SequenceStatus(StrEnum):
    """How the search for a plan against a known sequence ended."""

    CONVERGED = "the best turns of a grid, refined until they stood still"
    STEPS_USED_UP = "the turns were still moving when the refinements were used up"


@dataclass(frozen=True, eq=False)
class SequencePlan(Value):
    """The plan for a pursuer that has announced its capture sequence and keeps to it.

    Attributes
    ----------
    sequence : tuple of int
        The capture sequence.
    turns : numpy.ndarray
        (N,) signed turns δ in [-π, π], radians, by evader.
    goal_headings : numpy.ndarray
        (N,) headings φ after the turn, radians in [-π, π], by evader.
    capture_times : numpy.ndarray
        (N,) least capture times in the order of `sequence`.
    survival_time : float
        The last capture time: the maximum of f_s over the turns.
    status : SequenceStatus
    unit : str
        Of the team's lengths; with one, all times are in seconds.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> told = covey.plan_for_sequence(team, disk, [2, 0, 1])
    >>> told.capture_times.round(3).tolist()
    [0.673, 1.857, 3.624]
    """

    sequence: tuple[int, ...]
    turns: Floats
    goal_headings: Floats
    capture_times: Floats
    survival_time: float
    status: SequenceStatus
    unit: str = ""

    def __repr__(self) -> str:
        """Return the last capture, the sequence, and how the search ended, in one line."""
        return one_line(
            "SequencePlan",
            survival_time=quantity(self.survival_time, units_with(self.unit).time),
            sequence=self.sequence,
            status=self.status,
        )

    def _repr_html_(self) -> str:
        columns = {
            "evader": self.sequence,
            titled("captured", units_with(self.unit).time): self.capture_times.tolist(),
            "turn (rad)": self.turns[[*self.sequence]].tolist(),
            "goal heading (rad)": self.goal_headings[[*self.sequence]].tolist(),
        }
        return html_table(repr(self), columns)


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
        Of turns that are equally good, the smallest on the grid. Compare survival times, never
        headings.

    Raises
    ------
    InputError
        If `sequence` isn't a permutation or an evader is as fast as the pursuer.

    Notes
    -----
    There are several local maxima: an evader between the pursuer and the next evader can dodge to
    either side. So the search is global. A later capture on the same path delays all captures after
    it, hence a dynamic programme over one turn at a time is exact on a grid of 65 turns for each
    evader. Finer grids around the best turns then refine them. Two maxima whose values differ by
    less than the square of the first grid's spacing may be confused. The bound of `covey.bracket`
    excludes that; it found no such case in 700 random games.

    With unlimited turn rates straight flight is optimal, and the turns solve the root-searching
    problem of [2]_. Let T_k be the k-th capture time, P_k the position of that capture, n_k the
    unit vector from P_{k-1} to P_k, and λ_k the derivative of T_N by a delay of the k-th flight
    alone. Then the k-th evader flies along λ_k n_k - λ_{k+1} n_{k+1}, and the last one straight
    away from P_{N-1}. A root may also be a minimum or a saddle, so the search begins at the grid's
    maximum. It gives the turns to the last digits; comparing times gives them to some 1e-8 only.

    References
    ----------
    .. [1] A. A. Chikrii, L. A. Sobolenko, S. F. Kalashnikova, "A numerical method for the solution
       of the successive pursuit-and-evasion problem", Cybernetics 24 (1988).
    .. [2] A. Belousov, Y. Berdyshev, A. Chentsov, A. Chikrii, "Solving the dynamic traveling
       salesman game problem", Cybernetics and Systems Analysis 46 (2010).

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> told = covey.plan_for_sequence(team, disk, [2, 0, 1])
    >>> told.survival_time >= covey.plan(team, disk).survival_time - 1e-9
    True
    """
    check_players(team, disk)
    team, disk = about_center(team, disk)
    order = permutation("sequence", sequence, len(team))
    found, converged = _best_turns(team, pursuit_of(disk), order)
    turns = np.where(np.isinf(team.turn_rates), wrap_angle(found), found)
    goals, times = wrap_angle(team.headings + turns), capture_times(team, disk, turns, order)
    return SequencePlan(
        sequence=tuple(order.tolist()),
        turns=read_only(turns),
        goal_headings=read_only(goals),
        capture_times=read_only(times),
        survival_time=float(times[-1]),
        status=SequenceStatus.CONVERGED if converged else SequenceStatus.STEPS_USED_UP,
        unit=team.unit,
    )


def _best_turns(team: Team, pursuit: Pursuit, order: Ints) -> tuple[Floats, bool]:
    """Return the turns (N,) with the latest last capture, and whether the search converged."""
    evaders = team.as_rows()
    if np.isinf(team.turn_rates).all():
        near, _ = _closed_in(evaders, pursuit, order, _ROOT_SEARCH_FROM)
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
