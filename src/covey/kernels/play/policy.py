"""How a built-in team plans while a game goes on, and what it remembers from plan to plan."""

from __future__ import annotations

from typing import NamedTuple

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats, Table
from covey.kernels.maximum.multistart import SearchScratch
from covey.kernels.maximum.objective import Aim, rule_out, spent
from covey.kernels.maximum.working_set import Columns, forget_captured
from covey.kernels.play.replanning import replan
from covey.kernels.play.rules import NOBODY, Rules, State, pursuit_from


class TeamPolicy(NamedTuple):
    """How a built-in team plans."""

    replans: bool  # iterative open loop, or open loop
    replan_time: float  # between two plans, unless there is a capture
    restarts: int  # other starts that are followed after a capture
    tolerance: float
    most_steps: int


class TeamMemory(NamedTuple):
    """What a team that plans again remembers."""

    columns: Columns
    noise: Table  # lays out the other starts
    last: Floats  # (2,) time and worth of the last plan; worth -inf: not known
    aim: Aim


@compiled
def plan_again(
    state: State,
    rules: Rules,
    team: TeamPolicy,
    memory: TeamMemory,
    taken: int,
    search: SearchScratch,
) -> None:
    """Let the living plan again if that is due: after some time, and after each capture.

    `taken` is the row in which somebody was captured and has been removed, or `NOBODY`.
    """
    alive, columns, aim = state.alive[0], memory.columns, memory.aim
    since = state.time[0] - memory.last[0]
    if taken != NOBODY:
        forget_captured(columns, alive + 1, taken)
        if aim.expected:
            rule_out(aim.draws, alive + 1, taken)
    if team.replans and alive > 0 and (taken != NOBODY or since >= team.replan_time):
        memory.last[1] = replan(
            state.evaders,
            alive,
            pursuit_from(state, rules),
            aim,
            memory.noise,
            team.restarts if taken != NOBODY else 0,
            team.tolerance,
            team.most_steps,
            memory.last[1] - spent(since, alive + (taken != NOBODY), aim.total),
            state.turns,
            columns,
            search,
        )
        memory.last[0] = state.time[0]
