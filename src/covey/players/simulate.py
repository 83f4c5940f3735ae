"""Play a game: compiled where both strategies come with the package, else in Python."""

from __future__ import annotations

from typing import TypedDict, Unpack

from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.players.compiled import (
    Played,
    checked_settings,
    play_compiled,
    pursuer_is_built_in,
    team_is_built_in,
)
from covey.players.pursuers.committed import CommittedPursuer
from covey.players.teams.open_loop import IterativeOpenLoop
from covey.simulation import (
    Game,
    Outcome,
    PursuerPolicy,
    PursuerStrategy,
    TeamPolicy,
    TeamStrategy,
    play,
)


def simulate(
    team: Team,
    disk: PursuerDisk,
    *,
    evaders: TeamStrategy | TeamPolicy = IterativeOpenLoop(),  # noqa: B008 frozen
    pursuer: PursuerStrategy | PursuerPolicy = CommittedPursuer(),  # noqa: B008 frozen
    sensing: str = "hidden",
    update_time: float = 0.01,
    seed: int = 0,
    time_limit: float | None = None,
    objective: Objective = LastCapture(),  # noqa: B008 frozen
) -> Game:
    """Play one game and return its record.

    Parameters
    ----------
    team, disk
        The state at time 0; up to 20 evaders, each slower than the pursuer.
    evaders, pursuer
        Strategies: values that come with the package, your own, or plain functions of a
        `Situation`.
    sensing
        "hidden": the team knows a disk that grows at the pursuer's speed and collapses at each
        capture. "visible": it sees the pursuer at every update.
    update_time
        Δt > 0 between updates; a capture brings one at once.
    seed
        The same call with the same seed gives the same game, bit for bit.
    time_limit
        A game is stopped then. None: by when a pursuer that kept to one sequence would have
        captured everybody, whatever the team did.
    objective
        What the team makes large and the pursuer small, where their strategies mind: `OpenLoop`,
        `IterativeOpenLoop` and `ConstantHeading` (see `covey.plan`), `CommittedPursuer`,
        `UncommittedPursuer` and `FlyingPursuer`. A pursuer doesn't reckon with expectations: it
        makes small what is measured.

    Returns
    -------
    Game
        `planned_value` is what the first plan made of the objective, `value` what came of it;
        `guarantee` and `survival_time` for the last capture.

    Raises
    ------
    InputError
        If an argument can't be used, or a strategy decides what it can't.
    """
    options = Options(
        evaders=evaders,
        pursuer=pursuer,
        sensing=sensing,
        update_time=update_time,
        seed=seed,
        time_limit=time_limit,
        objective=objective,
    )
    played = _play(team, disk, options, recorded=True)
    return played if isinstance(played, Game) else played.record()


class Options(TypedDict, total=False):
    """The keyword arguments of `simulate`."""

    evaders: TeamStrategy | TeamPolicy
    pursuer: PursuerStrategy | PursuerPolicy
    sensing: str
    update_time: float
    seed: int
    time_limit: float | None
    objective: Objective


def survival(team: Team, disk: PursuerDisk, **options: Unpack[Options]) -> Outcome:
    """Play the game that `simulate` plays, to the last bit, and keep no record of its course.

    Parameters
    ----------
    team, disk, options
        See `simulate`.

    Returns
    -------
    Outcome
        What the record of the game would say.
    """
    return _play(team, disk, options, recorded=False).outcome()


_DEFAULTS = Options(
    evaders=IterativeOpenLoop(),
    pursuer=CommittedPursuer(),
    sensing="hidden",
    update_time=0.01,
    seed=0,
    time_limit=None,
    objective=LastCapture(),
)


def _play(team: Team, disk: PursuerDisk, given: Options, *, recorded: bool) -> Played | Game:
    """Play a game; a compiled game is logged only where it is `recorded`."""
    options = _DEFAULTS | given
    evaders, pursuer = options["evaders"], options["pursuer"]
    settings = checked_settings(
        team,
        disk,
        options["sensing"],
        options["update_time"],
        options["seed"],
        options["time_limit"],
        options["objective"],
    )
    if team_is_built_in(evaders) and pursuer_is_built_in(pursuer):
        return play_compiled(team, disk, evaders, pursuer, settings, recorded=recorded)
    return play(team, disk, evaders, pursuer, settings)
