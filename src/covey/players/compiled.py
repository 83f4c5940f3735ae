"""Games of the strategies that come with the package, played compiled from end to end."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeGuard

from covey.kernels.play.game import GameLog, allocate_log, cut_log, grow_log, play
from covey.model import Objective, PursuerDisk, Team, objective_value
from covey.planning import Plan, plan
from covey.planning.guarantee import check_game, longest_game
from covey.planning.workspace import workspace
from covey.players.pursuers.committed import CommittedPursuer
from covey.players.pursuers.fixed_order import BestSequence, FixedSequence, RandomSequence
from covey.players.teams.open_loop import IterativeOpenLoop, OpenLoop, first_memory
from covey.simulation import Game, Outcome, Settings
from covey.simulation.build_record import GameSetup, build_record
from covey.simulation.settings import first_state

BuiltInTeam = OpenLoop | IterativeOpenLoop
BuiltInPursuer = CommittedPursuer | FixedSequence | BestSequence | RandomSequence

_FIRST_ROWS = 256


class Played(NamedTuple):
    """A compiled game that was played."""

    setup: GameSetup
    plan: Plan  # the first
    log: GameLog  # without rows unless the game was recorded

    def record(self) -> Game:
        """Return the record of a game that was recorded."""
        return build_record(self.setup, self.log)

    def outcome(self) -> Outcome:
        """Return what came of the game."""
        log = cut_log(self.log)
        times, done = log.capture_times, len(log.order) == len(self.setup.team)
        return Outcome(
            self.plan.survival_time,
            float(times[-1]) if done else math.inf,
            self.plan.value,
            objective_value(self.setup.settings.objective, times) if done else math.inf,
            log.order,
            times,
        )


def team_is_built_in(evaders: object) -> TypeGuard[BuiltInTeam]:
    """Return whether a team's strategy can play compiled."""
    return isinstance(evaders, BuiltInTeam)


def pursuer_is_built_in(pursuer: object) -> TypeGuard[BuiltInPursuer]:
    """Return whether a pursuer's strategy can play compiled."""
    return isinstance(pursuer, BuiltInPursuer)


def checked_settings(
    team: Team,
    disk: PursuerDisk,
    sensing: str,
    update_time: float,
    seed: int,
    time_limit: float | None,
    objective: Objective,
) -> Settings:
    """Return the settings of a game; raise InputError if it can't be played."""
    check_game(team, disk)
    limit = longest_game(team, disk) if time_limit is None else time_limit
    return Settings(sensing, update_time, seed, limit, objective)


def play_compiled(
    team: Team,
    disk: PursuerDisk,
    evaders: BuiltInTeam,
    pursuer: BuiltInPursuer,
    settings: Settings,
    *,
    recorded: bool,
) -> Played:
    """Play a game; with `recorded`, log its course."""
    n, objective, team_options = len(team), settings.objective, evaders.compiled()
    commitment = pursuer.commitment(team, disk, settings.seed)
    first = plan(team, disk, objective=objective, seed=settings.seed, starts=evaders.starts)
    memory = first_memory(first, settings.seed, team_options.restarts)
    state, rules = first_state(team, disk), settings.rules(disk)
    state.turns[:] = first.turns
    log, scratch = (
        allocate_log(_FIRST_ROWS if recorded else 0, n),
        workspace(n, memory.objective.total),
    )
    while not play(state, rules, team_options, memory, commitment, log, scratch):
        log, commitment = grow_log(log), commitment._replace(is_chosen=True)
    strategies = {"evaders": evaders.describe(), "pursuer": pursuer.describe()}
    return Played(GameSetup(team, disk, settings, strategies), first, log)
