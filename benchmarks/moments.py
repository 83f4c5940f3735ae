"""The games that are measured, at their start and two updates later, and a method's answer."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

import covey
from covey.kernels.maximum.problem import Problem
from covey.kernels.maximum.working_set import WorkingSet
from covey.kernels.play.policy import replan
from covey.kernels.play.rules import NOBODY, Rules, announce, fly, initial_state
from covey.planning.border import pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.workspace import workspace
from covey.players.teams.open_loop import first_memory

UPDATE_TIME = 0.01


class Situation(NamedTuple):
    """A state of the game, and turns from which to plan."""

    team: covey.Team
    disk: covey.PursuerDisk
    turns: np.ndarray  # (N,)


class Moment(NamedTuple):
    """A game at its start, then after an update and a replan, then after another update.

    In between the visible pursuer flies towards the first of the plan's worst sequence, and the
    evaders along their plan: what is left of it is where a warm replan starts.
    """

    first: Situation  # with the turns to flight straight away
    before: Situation  # with the turns of the last plan
    now: Situation  # with what is left of them
    plan: covey.Plan  # the last one as a record
    working_set: WorkingSet  # the last one's, as a game carries it over
    lower_bound: float  # of what is left of the last one: its value less the time since


class Answer(NamedTuple):
    """What a method took and reached on a moment."""

    seconds: float
    value: float
    settled: bool = True  # whether this planner, starting from there, finds nothing better


def moments(size):
    """Yield games as in section V of the paper: uniform in the unit square, headings away."""
    generator, disk = np.random.default_rng(size), covey.PursuerDisk()
    rules = Rules(1.0, 0.0, False, UPDATE_TIME, math.inf)
    options = covey.IterativeOpenLoop().compiled()
    objective = compiled_objective(covey.LastCapture(), size)
    while True:
        positions = generator.uniform(-0.5, 0.5, (size, 2))
        bearings = np.arctan2(positions[:, 1], positions[:, 0])
        team = covey.Team(positions, bearings)
        first = Situation(team, disk, covey.turns_to(team, bearings))
        plan = covey.plan(team, disk, starts=1)
        memory, target = first_memory(plan, 0, 0), plan.critical_sequences[0][0]
        state = initial_state(team.as_rows(), 0.0, 0.0, 0.0)
        state.turns[:] = plan.turns
        announce(state, rules)
        if fly(state, rules, target, 0.0, 0.0) != NOBODY:
            continue  # captured before there is anything to replan: the next team
        memory.last[1] = plan.survival_time
        seen = covey.PursuerDisk(state.disk[:2])
        problem = Problem(state.evaders, pursuit_of(seen), objective)
        replan(problem, options, memory, UPDATE_TIME, 0, state.turns, workspace(size))
        before = _situation(state)
        announce(state, rules)
        if fly(state, rules, target, 0.0, 0.0) != NOBODY:
            continue
        last = covey.plan(before.team, before.disk, starts=1, warm_start=before.turns)
        lower_bound = float(memory.last[1]) - UPDATE_TIME
        yield Moment(first, before, _situation(state), last, memory.working_set, lower_bound)


def _situation(state):
    team = covey.Team(state.evaders[:, :2], state.evaders[:, 2])
    return Situation(team, covey.PursuerDisk(state.disk[:2]), state.turns.copy())
