"""The open-loop plan that survives longest against any pursuer: the max-min of eq. (6)."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from covey.kernels.maximum.initial_guesses import CANDIDATES
from covey.kernels.maximum.sqp import CONVERGED, STALLED, STEPS_USED_UP
from covey.kernels.maximum.working_set import Columns, make_columns
from covey.model import ExpectedSurvival, InputError, LastCapture, Objective, PursuerDisk, Team
from covey.model.angles import wrap_angle
from covey.model.validation import Floats, frozen_array, number, read_only, whole_number
from covey.planning.compiled_objective import aim_of, checked_objective
from covey.planning.guarantee import check_game, guaranteed_survival
from covey.planning.multistart import Multistart

DEFAULT_STARTS = 32
"""Starts of the first plan of a game that is played; `plan` by itself follows `default_starts`."""
DEFAULT_TOLERANCE = 1e-9
SIDE_BY_SIDE = 9
"""From this many evaders on, starts are followed on several cores: each takes milliseconds."""
CRITICAL_WITHIN = 1e-6
"""Sequences within this of the guaranteed time, relative, count as critical."""


class PlanStatus(StrEnum):
    """How the search for a plan ended."""

    CONVERGED = "a local maximum, the best of all starts"
    STALLED = "the best of all starts, where rounding ended the ascent short of the tolerance"
    STEPS_USED_UP = "the best start was still rising when its steps were used up"
    TIME_LIMIT = "the time limit ended the search; the best of the starts made until then"


_STATUS = {
    CONVERGED: PlanStatus.CONVERGED,
    STALLED: PlanStatus.STALLED,
    STEPS_USED_UP: PlanStatus.STEPS_USED_UP,
}


@dataclass(frozen=True, eq=False)
class Plan:
    """A plan for the whole team, and what it guarantees.

    Attributes
    ----------
    turns : numpy.ndarray
        (N,) signed turns δ in [-π, π], radians: turn by δ at full rate, then fly straight.
    goal_headings : numpy.ndarray
        (N,) headings φ after the turn, radians in [-π, π].
    survival_time : float
        Guaranteed against any pursuer in the disk: the exact minimum over all capture sequences at
        these turns, whatever the search did.
    objective : LastCapture or TotalSurvival or ExpectedSurvival
        What the plan makes large.
    value : float
        What it makes of it, exactly: for the last capture, the `survival_time`.
    critical_sequences : tuple of tuple of int
        Capture sequences that attain the value, or come within 1e-6 of it, relative, as far as the
        search met them; the worst first. For an expectation, the sequences that it runs over.
    status : PlanStatus
    weights : tuple of float
        For each critical sequence the share with which it holds the plan where it is: the Lagrange
        multipliers of eq. (6), >= 0, summing to 1. For an expectation, their probabilities.
    starts, steps, interceptions : int
        What the search cost: starts followed to the end, steps of sequential quadratic
        programming, interceptions computed by the dynamic programme.
    """

    turns: Floats
    goal_headings: Floats
    survival_time: float
    objective: Objective
    value: float
    critical_sequences: tuple[tuple[int, ...], ...]
    weights: tuple[float, ...]
    status: PlanStatus
    starts: int
    steps: int
    interceptions: int


def plan(
    team: Team,
    disk: PursuerDisk,
    *,
    objective: Objective = LastCapture(),  # noqa: B008 frozen
    seed: int = 0,
    starts: int | None = None,
    tolerance: float = DEFAULT_TOLERANCE,
    time_limit: float | None = None,
    warm_start: Plan | npt.ArrayLike | None = None,
) -> Plan:
    """Find the open-loop plan with the longest guaranteed survival time, or another objective.

    Parameters
    ----------
    team, disk
        The state of the game; up to 20 evaders, each slower than the pursuer.
    objective
        What is made large: by default the last capture, guaranteed; `TotalSurvival()`, the sum of
        all survival times, guaranteed; `ExpectedSurvival(...)`, the expected value of either over a
        pursuer that draws its sequence.
    seed
        Seed of the random starts. The same call gives the same plan, bit for bit.
    starts
        How many starts are followed to their local maximum: the warm start, flight straight away
        from the disk's centre, random ones, each the best of eight, and variations of the best
        plans so far. More starts include the fewer, and never give less. None: as many as find the
        best plan known in most games, see `default_starts`. From nine evaders on, four starts at a
        time are followed side by side; the result is the same on any number of cores.
    tolerance
        An ascent ends when a step promises less than this, relative to the value.
    time_limit
        Seconds after which no further start is followed; the first always is. None: no limit.
    warm_start
        A Plan, or (N,) turns in [-π, π], to start from. The result is never worse than it.

    Returns
    -------
    Plan
        Where several turns are equally good (an evader that is caught while it turns leaves the
        angle of its turn open), the first start that came to them decides; compare survival times,
        never headings.

    Raises
    ------
    InputError
        If an argument can't be used.

    Notes
    -----
    The max-min of eq. (6) in the signed turns δ, where the guaranteed time is continuous.
    Sequential quadratic programming with exact second derivatives on a few capture sequences; a
    dynamic programme over subsets finds the sequence that is missing (column generation). For the
    sum its states carry pairs (docs/decisions/0009); an expectation needs no search for the worst,
    and its ascents are Newton's method.
    The programme takes 16 N 2^N bytes for each of up to four cores, for the sum 40 N 2^N.
    """
    check_game(team, disk)
    number("tolerance", tolerance, low=0.0, strictly=True)
    if time_limit is not None:
        number("time_limit", time_limit, low=0.0)
    n = len(team)
    starts = default_starts(n) if starts is None else whole_number("starts", starts, low=1)
    late = math.inf if time_limit is None else time.perf_counter() + time_limit
    aim = aim_of(checked_objective(objective), n)
    search = Multistart(team, disk, aim, tolerance)
    if warm_start is not None:
        search.go_on_from(*_start_of(warm_start, team))
        starts -= 1
    noise = start_noise(seed, starts, n)
    if late < math.inf or (n >= SIDE_BY_SIDE and starts > 1):
        in_time = search.follow_side_by_side(noise, starts, late)
    else:
        in_time = True
        search.follow_all(noise, starts)
    search.finish()
    return _plan_of(search, team, disk, objective, in_time)


def default_starts(n: int) -> int:
    """Return how many starts `plan` follows for n evaders.

    Measured, docs/decisions/0008 and benchmarks/quality.py: the plan is then within 1e-3 of the
    best that 500 starts find in all games of three evaders, 99 of 100 of five and 92 of 100 of
    eight. From thirteen evaders on it is what seconds allow.
    """
    if n > 12:
        return 24
    return 56 if n in (4, 5) else 100


def _plan_of(
    search: Multistart, team: Team, disk: PursuerDisk, objective: Objective, in_time: bool
) -> Plan:
    assert search.best is not None
    best, survival_time = search.best, search.best.value
    if not isinstance(objective, LastCapture):
        survival_time = guaranteed_survival(team, disk, best.turns).time
    if isinstance(objective, ExpectedSurvival):
        held = _drawn(search.draws)
    else:
        held = _held(best.columns, best.values, best.value)
    return Plan(
        turns=read_only(best.turns),
        goal_headings=read_only(wrap_angle(team.headings + best.turns)),
        survival_time=survival_time,
        objective=objective,
        value=best.value,
        critical_sequences=tuple(sequence for sequence, _ in held),
        weights=tuple(weight for _, weight in held),
        status=_STATUS[best.ended] if in_time else PlanStatus.TIME_LIMIT,
        starts=search.done,
        steps=search.steps,
        interceptions=search.interceptions,
    )


def start_noise(seed: int, starts: int, n: int) -> Floats:
    """Return the random numbers in [-1, 1] that lay out `starts` starts for n evaders."""
    whole_number("seed", seed, low=0)
    if starts <= 1:
        return np.empty((0, n))
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (CANDIDATES * (starts - 1), n))


def columns_of(plan: Plan) -> Columns:
    """Return the plan's critical sequences as the columns that a warm ascent starts with."""
    columns = make_columns(len(plan.turns))
    if isinstance(plan.objective, ExpectedSurvival):
        return columns
    count = min(len(plan.weights), len(columns.weights))
    columns.used[0] = count
    columns.sequences[:count] = plan.critical_sequences[:count]
    columns.weights[:count] = plan.weights[:count]
    return columns


def _start_of(warm_start: Plan | npt.ArrayLike, team: Team) -> tuple[Floats, Columns]:
    """The turns of a warm start, and the columns that come with them."""
    turns = _turns_of(warm_start, team)
    return turns, columns_of(warm_start) if isinstance(warm_start, Plan) else make_columns(
        len(team)
    )


def _turns_of(warm_start: Plan | npt.ArrayLike, team: Team) -> Floats:
    if isinstance(warm_start, Plan) and len(warm_start.turns) == len(team):
        return np.where(team.turn_rates > 0.0, warm_start.turns, 0.0)
    turns = warm_start.turns if isinstance(warm_start, Plan) else warm_start
    checked = frozen_array("warm_start", turns, (len(team),))
    if np.abs(checked).max() > math.pi:
        raise InputError(f"warm_start: expected turns in [-π, π], got {checked.tolist()}")
    return np.where(team.turn_rates > 0.0, checked, 0.0)


def _drawn(draws: Columns) -> list[tuple[tuple[int, ...], float]]:
    """The sequences of an expectation with their probabilities, the likeliest first."""
    rows = zip(map(tuple, draws.sequences.tolist()), draws.weights.tolist(), strict=True)
    return sorted((row for row in rows if row[1] > 0.0), key=lambda row: -row[1])


def _held(columns: Columns, values: Floats, value: float) -> list[tuple[tuple[int, ...], float]]:
    """The columns that attain the value, the worst one first, with their weights."""
    count = len(values)
    rows = zip(
        values.tolist(),
        map(tuple, columns.sequences[:count].tolist()),
        columns.weights[:count].tolist(),
        strict=True,
    )
    latest = value * (1.0 + CRITICAL_WITHIN)
    return [(sequence, weight) for each, sequence, weight in sorted(rows) if each <= latest]
