"""Games of the strategies that come with the package, played compiled from end to end."""

from __future__ import annotations

from typing import NamedTuple, TypeGuard

from covey.kernels.maximum.multistart import search_scratch
from covey.kernels.play import game
from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.model.validation import Floats, Ints
from covey.planning import Plan, plan
from covey.planning.guarantee import check_game, longest_game
from covey.players.pursuers.committed import CommittedPursuer
from covey.players.pursuers.fixed_order import BestSequence, FixedSequence, RandomSequence
from covey.players.teams.open_loop import IterativeOpenLoop, OpenLoop, first_memory
from covey.simulation import Settings
from covey.simulation.settings import first_state

BuiltInTeam = OpenLoop | IterativeOpenLoop
BuiltInPursuer = CommittedPursuer | FixedSequence | BestSequence | RandomSequence


class Played(NamedTuple):
    """What comes out of a compiled game."""

    plan: Plan  # the first
    order: Ints  # (C,) the captured
    times: Floats  # (C,)
    pages: game.Pages
    written: int  # pages; none unless the game was recorded


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
    objective: Objective = LastCapture(),  # noqa: B008 frozen
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
    """Play a game; with `recorded`, write a page at every decision."""
    n, policy = len(team), evaders.compiled()
    margin, sequence, known = pursuer.commitment(team, disk, settings.seed)
    first = plan(
        team, disk, objective=settings.objective, seed=settings.seed, starts=evaders.starts
    )
    memory = first_memory(first, settings.seed, policy.restarts)
    state = first_state(team, disk)
    state.turns[:] = first.turns
    captured, order, times, count, pages = game.play(
        state,
        settings.rules(disk),
        policy,
        memory,
        margin,
        sequence,
        known,
        recorded,
        search_scratch(n, memory.aim.total),
    )
    return Played(first, order[:captured], times[:captured], pages, count)
