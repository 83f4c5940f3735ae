"""The games that are measured, at their start and two updates later, and a method's answer."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from covey.kernels.play.replanning import replan

import covey
from covey.kernels.maximum.multistart import search_scratch
from covey.kernels.maximum.working_set import Columns
from covey.kernels.play.rules import NOBODY, Rules, announce, fly, initial_state, pursuit_from
from covey.planning.compiled_objective import aim_of
from covey.planning.multistart import MOST_STEPS
from covey.planning.open_loop import columns_of, start_noise
from covey.players.teams.open_loop import REPLAN_TOLERANCE

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
    columns: Columns  # the last one's, as a game carries them over
    worth: float  # what the last one is worth at least, less the time since


class Answer(NamedTuple):
    """What a method took and reached on a moment."""

    seconds: float
    value: float
    settled: bool = True  # whether this planner, starting from there, finds nothing better


def moments(size):
    """Yield games as in section V of the paper: uniform in the unit square, headings away."""
    generator, disk = np.random.default_rng(size), covey.PursuerDisk()
    rules = Rules(1.0, 0.0, False, UPDATE_TIME, math.inf)
    noise, scratch = start_noise(0, 1, size), search_scratch(size)
    aim = aim_of(covey.LastCapture(), size)
    while True:
        positions = generator.uniform(-0.5, 0.5, (size, 2))
        bearings = np.arctan2(positions[:, 1], positions[:, 0])
        team = covey.Team(positions, bearings)
        first = Situation(team, disk, covey.turns_to(team, bearings))
        plan = covey.plan(team, disk, starts=1)
        columns, target = columns_of(plan), plan.critical_sequences[0][0]
        state = initial_state(team.as_rows(), 0.0, 0.0, 0.0)
        state.turns[:] = plan.turns
        announce(state, rules)
        if fly(state, rules, target, 0.0, 0.0) != NOBODY:
            continue  # captured before there is anything to replan: the next team
        worth = replan(
            state.evaders,
            size,
            pursuit_from(state, rules),
            aim,
            noise,
            0,
            REPLAN_TOLERANCE,
            MOST_STEPS,
            plan.survival_time - UPDATE_TIME,
            state.turns,
            columns,
            scratch,
        )
        before = _situation(state)
        announce(state, rules)
        if fly(state, rules, target, 0.0, 0.0) != NOBODY:
            continue
        last = covey.plan(before.team, before.disk, starts=1, warm_start=before.turns)
        yield Moment(first, before, _situation(state), last, columns, worth - UPDATE_TIME)


def _situation(state):
    team = covey.Team(state.evaders[:, :2], state.evaders[:, 2])
    return Situation(team, covey.PursuerDisk(state.disk[:2]), state.turns.copy())
