"""Play a game: compiled where both strategies come with the package, else in Python."""

from __future__ import annotations

from typing import Any

from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.players.compiled import (
    checked_settings,
    play_compiled,
    pursuer_is_built_in,
    team_is_built_in,
)
from covey.players.pursuers.committed import CommittedPursuer
from covey.players.teams.open_loop import IterativeOpenLoop
from covey.simulation import (
    Game,
    PursuerPolicy,
    PursuerStrategy,
    TeamPolicy,
    TeamStrategy,
    play,
)
from covey.simulation.build_record import assemble


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
        What the team maximises and the pursuer minimises. These strategies use the objective:
        `OpenLoop`, `IterativeOpenLoop` and `ConstantHeading` (see `covey.plan`),
        `CommittedPursuer`, `UncommittedPursuer` and `FlyingPursuer`. A pursuer minimises what is
        measured, not its expectation.

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
    settings = checked_settings(team, disk, sensing, update_time, seed, time_limit, objective)
    if not (team_is_built_in(evaders) and pursuer_is_built_in(pursuer)):
        return play(team, disk, evaders, pursuer, settings)
    played = play_compiled(team, disk, evaders, pursuer, settings, recorded=True)
    strategies: dict[str, Any] = {"evaders": evaders.describe(), "pursuer": pursuer.describe()}
    return assemble(
        team, disk, settings, strategies, played.order, played.times, played.pages, played.written
    )
