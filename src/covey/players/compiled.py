"""Games of the strategies that come with the package, played compiled from end to end."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeGuard

from covey.kernels.arrays import Workspace
from covey.kernels.maximum.objective import Objective as CompiledObjective
from covey.kernels.play.game import allocate_log, grow_log, play
from covey.kernels.play.policy import ReplanOptions, TeamMemory
from covey.kernels.play.rules import State
from covey.model import Objective, PursuerDisk, Team
from covey.model.validation import LARGEST
from covey.planning import Plan
from covey.planning.border import about_center, check_game, longest_game
from covey.planning.compiled_objective import checked_objective
from covey.planning.long_calls import interceptions_of, interruptible
from covey.planning.open_loop import first_plan
from covey.players.pursuers.committed import CommittedPursuer
from covey.players.pursuers.fixed_order import BestSequence, FixedSequence, RandomSequence
from covey.players.teams.open_loop import UPDATE_VALUES, IterativeOpenLoop, OpenLoop, first_memory
from covey.simulation import Settings
from covey.simulation.build_record import Played
from covey.simulation.settings import GameSetup, first_state

BuiltInTeam = OpenLoop | IterativeOpenLoop
BuiltInPursuer = CommittedPursuer | FixedSequence | BestSequence | RandomSequence

_FIRST_ROWS = 256  # of a log, which grows


class InitialGame(NamedTuple):
    """A compiled game at time 0, with the team's first plan announced."""

    plan: Plan
    state: State
    options: ReplanOptions
    memory: TeamMemory


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
    objective: Objective | str,
) -> Settings:
    """Return the settings of a game; raise InputError if it can't be played."""
    check_game(team, disk)
    if time_limit is None:
        longest = longest_game(team, disk)
        time_limit = longest if 0.0 < longest <= LARGEST else math.inf
    return Settings(sensing, update_time, seed, time_limit, checked_objective(objective))


def initial_game(
    team: Team, disk: PursuerDisk, evaders: BuiltInTeam, settings: Settings
) -> InitialGame:
    """Make the team's first plan, and what its game is played on."""
    options, objective = evaders.compiled(), settings.objective
    team, disk = about_center(team, disk)
    first = first_plan(team, disk, objective, settings.seed, evaders.starts)
    memory = first_memory(first, settings.seed, options.restarts)
    state = first_state(team, disk)
    state.turns[:] = first.turns
    return InitialGame(first, state, options, memory)


def play_compiled(
    team: Team,
    disk: PursuerDisk,
    evaders: BuiltInTeam,
    pursuer: BuiltInPursuer,
    settings: Settings,
    *,
    recorded: bool,
) -> Played:
    """Play a game; if `recorded`, its log has a row for every decision."""
    strategies = {"evaders": evaders.describe(), "pursuer": pursuer.describe()}
    setup = GameSetup(team, disk, settings, strategies)
    team, disk = about_center(team, disk)
    commitment = pursuer.commitment(team, disk, settings.seed)
    first, state, options, memory = initial_game(team, disk, evaders, settings)
    rules, log = settings.rules(disk), allocate_log(_FIRST_ROWS if recorded else 0, len(team))

    def go_on(scratch: Workspace) -> bool:
        return play(state, rules, options, memory, commitment, log, scratch)

    work = game_interceptions(first, memory.objective, settings)
    while not interruptible(go_on, len(team), memory.objective.total, work):
        log, commitment = grow_log(log), commitment._replace(is_chosen=True)
    return Played(setup, first.survival_time, first.value, log)


def game_interceptions(first: Plan, objective: CompiledObjective, settings: Settings) -> float:
    """Return how many interceptions a game takes, about; for `interruptible`."""
    updates = first.survival_time / settings.update_time
    return UPDATE_VALUES * updates * interceptions_of(objective, len(first.turns))
