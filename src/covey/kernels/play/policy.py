"""How a built-in team replans during a game, and what it keeps from plan to plan."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.kernels._jit import compiled, entry, inlined
from covey.kernels.arrays import Matrix, Vector, Workspace
from covey.kernels.library.layout import kept
from covey.kernels.maximum.multistart import RADIUS_WARM, refine
from covey.kernels.maximum.objective import Objective, condition_on_capture, elapsed_value
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.maximum.working_set import WorkingSet, drop_evader
from covey.kernels.play.rules import NOBODY, Rules, State, pursuit_from

UPDATE_STEPS = 8
"""Steps of an update that improves the last plan alone; the next update goes on from there."""


class ReplanOptions(NamedTuple):
    """How a built-in team plans."""

    replans: bool  # iterative open loop, or open loop
    interval: float  # least time between two plans, unless there is a capture
    restarts: int  # initial guesses other than the last plan, after a capture
    tolerance: float
    max_steps: int


@kept
class TeamMemory(NamedTuple):
    """What a team that replans keeps. All arrays are modified in place."""

    working_set: WorkingSet
    uniforms: Matrix  # of the initial guesses
    last: Vector  # (2,) time and value of the last plan; value -inf: unknown
    objective: Objective


@compiled
def replan_if_due(
    state: State,
    rules: Rules,
    options: ReplanOptions,
    memory: TeamMemory,
    captured_row: int,
    workspace: Workspace,
) -> None:
    """Let the living replan where that is due: after the interval, and after each capture.

    Parameters
    ----------
    state
        Of the game; `turns` is modified in place.
    rules
        Of the game.
    options
        How the team plans.
    memory
        Modified in place.
    captured_row
        Row of the evader that was captured and has been removed, or `NOBODY`.
    workspace
        With room for all evaders; modified in place.
    """
    n, after_capture = state.alive[0], captured_row != NOBODY
    if after_capture:
        forget(memory, n + 1, captured_row)
    elapsed = state.time[0] - memory.last[0]
    if options.replans and n > 0 and (after_capture or elapsed >= options.interval):
        problem = Problem(state.evaders[:n], pursuit_from(state.disk, rules), memory.objective)
        spent = elapsed_value(elapsed, n + after_capture, memory.objective.total)
        restarts = options.restarts if after_capture else 0
        replan(problem, options, memory, spent, restarts, state.turns[:n], workspace)
        memory.last[0] = state.time[0]


@entry
def replan(
    problem: Problem,
    options: ReplanOptions,
    memory: TeamMemory,
    spent: float,
    restarts: int,
    turns: Vector,
    workspace: Workspace,
) -> None:
    """Improve the turns (n,) that are flown, from them and from other initial guesses.

    The value of the given turns is at least the last plan's value less what was `spent` since,
    whatever a pursuer did that keeps to the rules.

    Parameters
    ----------
    problem
        The living evaders (n), the pursuit, the objective.
    options
        How the team plans.
    memory
        Working set and `last[1]`, the value, are modified in place.
    spent
        By how much the value of the last plan has fallen since.
    restarts
        How many initial guesses are improved too; none of a team that is too large for an exact
        minimum at each step.
    turns
        (n,) still to be flown, radians; modified in place.
    workspace
        With room for n evaders; modified in place.
    """
    steps = options.max_steps if restarts > 0 else min(options.max_steps, UPDATE_STEPS)
    is_large = len(turns) >= workspace.fewest_walking
    if is_large and not (problem.objective.total or problem.objective.expected):
        restarts = 0
    value, _, _, _ = refine(
        problem,
        memory.uniforms,
        restarts,
        Options(RADIUS_WARM, options.tolerance, steps),
        memory.last[1] - spent,
        Iterate(turns, memory.working_set),
        workspace,
    )
    memory.last[1] = value


@inlined
def promised_time(state: State, options: ReplanOptions, memory: TeamMemory) -> float:
    """Return what the last plan still guarantees; -inf: unknown.

    The plan of a team that doesn't replan may guarantee more by now, so it is unknown too.
    """
    if memory.objective.total or memory.objective.expected or not options.replans:
        return -math.inf
    return memory.last[1] - (state.time[0] - memory.last[0])


@compiled
def forget(memory: TeamMemory, n: int, evader: int) -> None:
    """Remove a captured evader from the memory of a team of n."""
    drop_evader(memory.working_set, n, evader)
    if memory.objective.expected:
        condition_on_capture(memory.objective.draws, n, evader)
