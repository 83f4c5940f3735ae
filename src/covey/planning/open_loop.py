"""`plan`, the search for the turns that survive longest against any pursuer: eq. (6)."""

from __future__ import annotations

import math
import time

import numpy as np
import numpy.typing as npt

from covey.kernels.arrays import FEWEST_WALKING
from covey.kernels.maximum.initial_guesses import CANDIDATES
from covey.kernels.maximum.objective import Draws
from covey.kernels.maximum.problem import Iterate, Problem
from covey.kernels.maximum.working_set import WorkingSet, new_working_set
from covey.model import ExpectedSurvival, InputError, LastCapture, Objective, PursuerDisk, Team
from covey.model.angles import wrap_angle
from covey.model.validation import (
    MOST_STARTS,
    Floats,
    frozen_array,
    number,
    read_only,
    shown,
    whole_number,
)
from covey.planning.border import about_center, check_game, pursuit_of
from covey.planning.compiled_objective import checked_objective, compiled_objective
from covey.planning.expectation import value_of_plan
from covey.planning.guarantee import worst_sequence
from covey.planning.long_calls import deadline_after
from covey.planning.multistart import NONE, Ascents, Search
from covey.planning.open_loop_plan import CRITICAL_WITHIN, PLAN_STATUS, Plan, PlanStatus

DEFAULT_STARTS = 32
"""Starts of the first plan of a game that is played; `plan` by itself follows `default_starts`."""
DEFAULT_TOLERANCE = 1e-9
_SHARE_OF_GUARANTEE = 0.3  # of the time limit, for a large team
_LEAST_FOR_GUARANTEE = 0.25  # seconds, but no more than half of the time limit


def plan(
    team: Team,
    disk: PursuerDisk,
    *,
    objective: Objective | str = LastCapture(),  # noqa: B008 frozen
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
        The state of the game; up to 50 evaders, for a sum up to 20. Each is slower than the
        pursuer.
    objective
        What is made large: by default the last capture, guaranteed; `TotalSurvival()`, the sum of
        all survival times, guaranteed; `ExpectedSurvival(...)`, the expected value of either over a
        pursuer that draws its sequence. A name as in scenario files is the objective with its
        defaults.
    seed
        Seed of the random starts. The same call gives the same plan, bit for bit.
    starts
        How many starts are improved to a local maximum: the warm start, flight straight away
        from the disk's centre, random ones, each the best of eight, and variations of the best
        plans so far. More starts include the fewer, so that they never give less. None: as many as
        find the best plan known in most games, see `default_starts`. From nine evaders on, four
        starts at a time run in parallel; the result is the same on any number of cores.
    tolerance
        An ascent ends when a step promises less than this, relative to the value.
    time_limit
        Seconds after which the search ends with the best turns so far; the first turns are always
        evaluated. None: no limit.
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
    dynamic programme over subsets finds the sequence that is missing (constraint generation). For
    the sum the states of the programme carry pairs (docs/decisions/0009). An expectation needs no
    search for the worst sequence, and its ascents are Newton's method. The programme takes
    16 N 2^N bytes for each of up to four cores, from eighteen evaders on up to 310 MB more; for the
    sum 40 N 2^N. From eighteen evaders on an ascent knows the sequences that moves find, and the
    programme says between ascents what the turns guarantee (docs/decisions/0016).

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> plan = covey.plan(team, disk)
    >>> round(plan.survival_time, 3)
    3.365
    >>> plan.goal_headings.round(2).tolist()
    [0.15, 2.31, -2.02]
    """
    check_game(team, disk)
    number("tolerance", tolerance, low=0.0, strictly=True)
    if time_limit is not None:
        number("time_limit", time_limit, low=0.0)
    n = len(team)
    starts = (
        default_starts(n)
        if starts is None
        else whole_number("starts", starts, low=1, high=MOST_STARTS)
    )
    deadline = deadline_after(time_limit)
    objective = checked_objective(objective)
    centered, about = about_center(team, disk)
    problem = Problem(centered.as_rows(), pursuit_of(about), compiled_objective(objective, n))
    warm = None if warm_start is None else _iterate_of(warm_start, team)
    guesses = starts - (warm is not None)
    search = Search(
        problem, tolerance, guess_uniforms(seed, guesses, n), _search_until(deadline, n)
    )
    best = _best_of(search, warm, guesses)

    # What the search found is computed again from the turns alone.
    guarantee = worst_sequence(centered, about, best.iterate.turns, False, deadline)
    if isinstance(objective, ExpectedSurvival):
        critical = _drawn(problem.objective.draws)
    else:
        critical = _critical(best)
    proven = max(guarantee.time, best.value) if search.is_rough else guarantee.time
    return _plan_of(team, disk, objective, best, critical, proven)


def _search_until(deadline: float, n: int) -> float:
    """Return when the search ends, so that time is left for the guarantee of a large team."""
    if n < FEWEST_WALKING or deadline == math.inf:
        return deadline
    left = deadline - time.perf_counter()
    return deadline - max(_SHARE_OF_GUARANTEE * left, min(_LEAST_FOR_GUARANTEE, 0.5 * left))


def _best_of(search: Search, warm: Iterate | None, guesses: int) -> Ascents:
    """Return the best of an ascent from the warm start, if any, and from initial guesses."""
    best = NONE if warm is None else search.refine(warm)
    if guesses > 0:
        best = search.run(best, guesses)
    if search.is_rough and best.in_time:
        exact = search.refine(best.iterate, best.value)
        best = exact._replace(starts=0).joined(best)
    return best


def first_plan(team: Team, disk: PursuerDisk, objective: Objective, seed: int, starts: int) -> Plan:
    """Return the first plan of a game whose strategy asks for so many starts."""
    followed = starts_followed(starts, len(team))
    return plan(team, disk, objective=objective, seed=seed, starts=followed)


def starts_followed(starts: int, n: int) -> int:
    """Return how many of a strategy's starts the first plan of n evaders follows.

    A large team follows no more than `plan` does by default: more of them would take minutes.
    """
    return starts if n < FEWEST_WALKING else min(starts, default_starts(n))


def default_starts(n: int) -> int:
    """Return how many starts `plan` follows for n evaders.

    Measured, docs/decisions/0008 and benchmarks/quality.py: the plan is then within 1e-3 of the
    best that 500 starts find in all games of three evaders, 99 of 100 of five and 92 of 100 of
    eight. From thirteen evaders on it is what seconds allow, from thirty-one on what minutes allow.
    """
    if n > 20:
        return 2 if n <= 30 else 1
    if n > 17:
        return 4
    if n > 12:
        return 24
    return 56 if n in (4, 5) else 100


def guess_uniforms(seed: int, guesses: int, n: int) -> Floats:
    """Return the random numbers in [-1, 1] that make `guesses` initial guesses for n evaders."""
    whole_number("seed", seed, low=0)
    if guesses <= 1:
        return np.empty((0, n))
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (CANDIDATES * (guesses - 1), n))


def working_set_of(plan: Plan) -> WorkingSet:
    """Return the plan's critical sequences as the working set of a warm ascent."""
    working_set = new_working_set(len(plan.turns))
    if isinstance(plan.objective, ExpectedSurvival):
        return working_set
    count = min(len(plan.weights), len(working_set.weights))
    working_set.used[0] = count
    working_set.sequences[:count] = plan.critical_sequences[:count]
    working_set.weights[:count] = plan.weights[:count]
    return working_set


Weighted = list[tuple[tuple[int, ...], float]]
"""Capture sequences with their weights."""


def _plan_of(
    team: Team,
    disk: PursuerDisk,
    objective: Objective,
    best: Ascents,
    critical: Weighted,
    survival_time: float,
) -> Plan:
    turns, value = best.iterate.turns, survival_time
    if not isinstance(objective, LastCapture):
        value = value_of_plan(team, disk, turns, objective)
    return Plan(
        team=team,
        disk=disk,
        turns=read_only(turns),
        goal_headings=read_only(wrap_angle(team.headings + turns)),
        survival_time=survival_time,
        objective=objective,
        value=value,
        critical_sequences=tuple(sequence for sequence, _ in critical),
        weights=tuple(weight for _, weight in critical),
        status=PLAN_STATUS[best.status] if best.in_time else PlanStatus.TIME_LIMIT,
        starts=best.starts,
        steps=best.steps,
        interceptions=best.interceptions,
    )


def _iterate_of(warm_start: Plan | npt.ArrayLike, team: Team) -> Iterate:
    """Return the turns of a warm start, and the working set of a plan."""
    turns = _turns_of(warm_start, team)
    if isinstance(warm_start, Plan):
        return Iterate(turns, working_set_of(warm_start))
    return Iterate(turns, new_working_set(len(team)))


def _turns_of(warm_start: Plan | npt.ArrayLike, team: Team) -> Floats:
    if isinstance(warm_start, Plan) and len(warm_start.turns) == len(team):
        return np.where(team.turn_rates > 0.0, warm_start.turns, 0.0)
    turns = warm_start.turns if isinstance(warm_start, Plan) else warm_start
    checked = frozen_array("warm_start", turns, (len(team),))
    if np.abs(checked).max() > math.pi:
        raise InputError(f"warm_start: expected turns in [-π, π], got {shown(checked.tolist())}")
    return np.where(team.turn_rates > 0.0, checked, 0.0)


def _drawn(draws: Draws) -> Weighted:
    """Return the sequences of an expectation with their probabilities, the likeliest first."""
    rows = zip(map(tuple, draws.sequences.tolist()), draws.probabilities.tolist(), strict=True)
    return sorted((row for row in rows if row[1] > 0.0), key=lambda row: -row[1])


def _critical(best: Ascents) -> Weighted:
    """Return the sequences that attain the value, the worst first, with their multipliers."""
    working_set = best.iterate.working_set
    count = int(working_set.used[0])
    rows = sorted(
        zip(
            working_set.values[:count].tolist(),
            map(tuple, working_set.sequences[:count].tolist()),
            working_set.weights[:count].tolist(),
            strict=True,
        )
    )
    least = rows[0][0] if rows else best.value  # the value of a large team is a lower bound
    latest = max(best.value, least) * (1.0 + CRITICAL_WITHIN)
    return [(sequence, weight) for each, sequence, weight in rows if each <= latest]
