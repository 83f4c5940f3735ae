"""What a plan guarantees: Algorithm 1 for one capture sequence, the exact minimum over all."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.kernels.arrays import (
    LARGEST_TABLE,
    MOST_EVADERS,
    MOST_IN_GAMES,
    STAGES_GIVEN,
    STAGES_OF_GUARANTEE,
    Workspace,
)
from covey.kernels.capture.path import PATH, set_paths
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import capture_times as sequence_times
from covey.kernels.maximum.problem import Problem
from covey.kernels.maximum.values import mean_over_draws, minimum_over_sequences
from covey.kernels.minimum.large.scratch import LOWER
from covey.model import (
    ExpectedSurvival,
    InputError,
    LastCapture,
    Objective,
    PursuerDisk,
    Team,
    TotalSurvival,
)
from covey.model.display import html_row, one_line, quantity
from covey.model.units import titled, units_with
from covey.model.validation import Floats, checked_array, number, permutation, require_kind, shown
from covey.planning.compiled_objective import checked_objective, compiled_objective
from covey.planning.long_calls import interceptions_of_minimum, interruptible
from covey.planning.workspace import workspace


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


def pursuit_of(disk: PursuerDisk) -> Pursuit:
    """Return the pursuer in the kernels' form."""
    x, y = disk.center.tolist()
    reach = disk.capture_radius
    return Pursuit(x, y, disk.radius + reach, 2.0 * reach, disk.speed)


def paths_of(team: Team, disk: PursuerDisk, turns: npt.ArrayLike) -> Floats:
    """Return the paths (N, PATH), in the kernels' form, of a team that makes `turns` (N,)."""
    checked = checked_array("turns", turns, (len(team),))
    paths = np.empty((len(team), PATH))
    set_paths(team.as_rows(), checked, disk.speed, paths)
    return paths


def check_players(team: Team, disk: PursuerDisk) -> None:
    """Raise InputError unless these are a team and a disk that fit, and every evader is slower."""
    require_kind("team", team, Team)
    require_kind("disk", disk, PursuerDisk)
    if team.unit and disk.unit and team.unit != disk.unit:
        raise InputError(
            f"unit: expected the same for the team and the disk, got {team.unit!r} and "
            f"{disk.unit!r}; nothing is converted"
        )
    disk.require_faster_than(team)


def check_game(team: Team, disk: PursuerDisk, most: int = MOST_IN_GAMES) -> None:
    """Raise InputError as `check_players` does, or if the team has more than `most` evaders."""
    check_players(team, disk)
    if len(team) > most:
        raise InputError(
            f"team: expected at most {most} evaders, got {len(team)}; guaranteed_survival serves "
            f"up to {MOST_EVADERS}, and so does plan with a time_limit"
        )


def about_center(team: Team, disk: PursuerDisk) -> tuple[Team, PursuerDisk]:
    """Return the team and the disk in the frame whose origin is the disk's centre.

    There the rounding of positions is relative to the size of the game, wherever the game is.
    """
    if disk.center.tolist() == [0.0, 0.0]:
        return team, disk
    return team.moved(-disk.center), disk.moved(-disk.center)


def longest_game(team: Team, disk: PursuerDisk) -> float:
    """Return a time by which a pursuer that keeps to any one sequence has captured everybody.

    An evader at distance d is captured within d / (v_p - v). Meanwhile the distance to the next
    evader grows by no more than both can fly.
    """
    offsets = team.positions - disk.center
    farthest = float(np.hypot(offsets[:, 0], offsets[:, 1]).max()) + disk.radius
    fastest = float(team.speeds.max())
    longest = 0.0
    for _ in range(len(team)):
        gap = 2.0 * farthest + (disk.speed + fastest) * longest
        longest += gap / (disk.speed - fastest)
    return longest


def capture_times(
    team: Team, disk: PursuerDisk, turns: npt.ArrayLike, sequence: npt.ArrayLike
) -> Floats:
    """Least times at which a pursuer from the disk can capture the team in a given order.

    Parameters
    ----------
    team, disk
        The state of the game.
    turns
        (N,) signed turns δ, radians: each evader turns by δ at full rate, then flies straight
        (eq. 5).
    sequence
        (N,) each evader 0..N-1 once.

    Returns
    -------
    numpy.ndarray
        (N,) capture times in the order of `sequence`, not decreasing; the last is f_s of the paper.

    Raises
    ------
    InputError
        If an argument has the wrong shape or an evader is as fast as the pursuer.

    References
    ----------
    Algorithm 1 of the paper.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> covey.capture_times(team, disk, turns=[0.0, 0.0, 0.0], sequence=[0, 1, 2]).round(3).tolist()
    [0.422, 1.363, 3.523]
    """
    check_players(team, disk)
    order = permutation("sequence", sequence, len(team))
    team, disk = about_center(team, disk)
    times = np.empty(len(team))
    sequence_times(paths_of(team, disk, turns), pursuit_of(disk), order, times)
    return times


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
    check_game(team, disk, MOST_EVADERS)
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


def deadline_after(time_limit: float | None) -> float:
    """Return the moment so many seconds from now, by `time.perf_counter`; None: inf."""
    return math.inf if time_limit is None else time.perf_counter() + time_limit


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


def expected_survival(
    team: Team, disk: PursuerDisk, turns: npt.ArrayLike, objective: ExpectedSurvival
) -> float:
    """Expected survival of a plan against a pursuer that draws its capture sequence.

    Parameters
    ----------
    team, disk
        The state of the game.
    turns
        (N,) signed turns δ, radians.
    objective
        The sequences, their probabilities, and whether the sum or the last capture is expected.

    Returns
    -------
    float
        The expected sum of all survival times, or the expected last capture. The pursuer flies each
        sequence as fast as possible (Algorithm 1).

    Raises
    ------
    InputError
        If an argument can't be used.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> any_order = covey.ExpectedSurvival(measure="last")
    >>> round(covey.expected_survival(team, disk, [0.0, 0.0, 0.0], any_order), 3)
    3.654
    """
    check_players(team, disk)
    if not isinstance(objective, ExpectedSurvival):
        raise InputError(f"objective: expected ExpectedSurvival(...), got {shown(objective)}")
    team, disk = about_center(team, disk)
    checked = checked_array("turns", turns, (len(team),))
    problem = Problem(team.as_rows(), pursuit_of(disk), compiled_objective(objective, len(team)))
    return mean_over_draws(problem, checked, workspace(len(team)))


def value_of_plan(
    team: Team, disk: PursuerDisk, turns: npt.ArrayLike, objective: Objective
) -> float:
    """Return the value of an objective at a plan's turns, guaranteed or expected."""
    if isinstance(objective, ExpectedSurvival):
        return expected_survival(team, disk, turns, objective)
    return guaranteed_survival(team, disk, turns, objective=objective).time
