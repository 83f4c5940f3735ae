"""What a plan guarantees: Algorithm 1 for one capture sequence, the exact minimum over all."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from covey.kernels.arrays import Workspace
from covey.kernels.capture.path import PATH, set_paths
from covey.kernels.capture.pursuit import Pursuit
from covey.kernels.capture.sequence import capture_times as sequence_times
from covey.kernels.maximum.problem import Problem
from covey.kernels.maximum.values import mean_over_draws, minimum_over_sequences
from covey.kernels.minimum.last_capture import MOST_EVADERS
from covey.model import (
    ExpectedSurvival,
    InputError,
    LastCapture,
    Objective,
    PursuerDisk,
    Team,
    TotalSurvival,
)
from covey.model.display import html_table
from covey.model.validation import Floats, checked_array, permutation, require_kind, shown
from covey.planning.compiled_objective import checked_objective, compiled_objective
from covey.planning.long_calls import interceptions_of_minimum, interruptible
from covey.planning.workspace import workspace


@dataclass(frozen=True)
class Guarantee:
    """A guaranteed survival time, or sum of survival times, and a sequence that attains it.

    Attributes
    ----------
    time : float
        The earliest time by which a pursuer in the disk can capture everybody; for `TotalSurvival`
        the least sum of all survival times.
    sequence : tuple of int
        A capture sequence that attains `time`.

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

    def _repr_html_(self) -> str:
        return html_table("Guarantee", {"time": [self.time], "sequence": [self.sequence]})


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
    """Raise InputError unless these are a team and a disk, and every evader is slower."""
    require_kind("team", team, Team)
    require_kind("disk", disk, PursuerDisk)
    disk.require_faster_than(team)


def check_game(team: Team, disk: PursuerDisk) -> None:
    """Raise InputError as `check_players` does, or if the team is too large."""
    check_players(team, disk)
    if len(team) > MOST_EVADERS:
        raise InputError(
            f"team: expected at most {MOST_EVADERS} evaders, got {len(team)}; the exact minimum "
            f"over all capture sequences needs 16 N 2^N bytes, so split the team"
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
    time = 0.0
    for _ in range(len(team)):
        gap = 2.0 * farthest + (disk.speed + fastest) * time
        time += gap / (disk.speed - fastest)
    return time


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
) -> Guarantee:
    """Survival time that a plan guarantees: the exact minimum over all capture sequences.

    Parameters
    ----------
    team, disk
        The state of the game; up to 20 evaders.
    turns
        (N,) signed turns δ, radians.
    objective
        What is guaranteed: the last capture, or `TotalSurvival()`, the sum of all survival times;
        or the name of either in scenario files.

    Returns
    -------
    Guarantee
        The time and a sequence that attains it.

    Raises
    ------
    InputError
        If an argument has the wrong shape, an evader is as fast as the pursuer, or the team is too
        large.

    Notes
    -----
    The two inner minima of eq. (6), by dynamic programming over subsets (Held and Karp, 1962)
    instead of N! sequences; memory 16 N 2^N bytes. For the sum a state needs pairs of the time and
    the sum so far, docs/decisions/0009; memory 40 N 2^N bytes.

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
    chosen = checked_objective(objective)
    if isinstance(chosen, ExpectedSurvival):
        raise InputError(
            "objective: expected LastCapture() or TotalSurvival(), got an expectation, which "
            "guarantees nothing; expected_survival computes it"
        )
    total = chosen.measure == "total"
    checked = checked_array("turns", turns, (len(team),))
    return worst_sequence(*about_center(team, disk), checked, total)


def worst_sequence(team: Team, disk: PursuerDisk, turns: Floats, total: bool) -> Guarantee:
    """Return the guarantee of checked turns (N,); `total`: of the sum of all survival times."""
    n, evaders, pursuit = len(team), team.as_rows(), pursuit_of(disk)
    sequence = np.empty(n, np.int64)

    def least(scratch: Workspace) -> float:
        return minimum_over_sequences(evaders, turns, pursuit, total, math.inf, sequence, scratch)

    time = interruptible(least, n, total, interceptions_of_minimum(n, total))
    return Guarantee(time, tuple(sequence.tolist()))


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
