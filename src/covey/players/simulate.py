"""Play a game: compiled where both strategies come with the package, else in Python."""

from __future__ import annotations

from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.players.compiled import (
    checked_settings,
    play_compiled,
    pursuer_is_built_in,
    team_is_built_in,
)
from covey.players.names import pursuer_strategy, team_strategy
from covey.players.pursuers.committed import CommittedPursuer
from covey.players.teams.open_loop import IterativeOpenLoop
from covey.simulation import (
    Game,
    Outcome,
    PursuerPolicy,
    PursuerStrategy,
    Settings,
    TeamPolicy,
    TeamStrategy,
)
from covey.simulation.build_record import Played, build_record, outcome_of
from covey.simulation.loop import play_out
from covey.simulation.match import Match


def simulate(
    team: Team,
    disk: PursuerDisk,
    *,
    evaders: TeamStrategy | TeamPolicy | str = IterativeOpenLoop(),  # noqa: B008 frozen
    pursuer: PursuerStrategy | PursuerPolicy | str = CommittedPursuer(),  # noqa: B008 frozen
    sensing: str = "hidden",
    update_time: float = 0.01,
    seed: int = 0,
    time_limit: float | None = None,
    objective: Objective | str = LastCapture(),  # noqa: B008 frozen
) -> Game:
    """Play one game and return its record.

    Parameters
    ----------
    team, disk
        The state at time 0; up to 50 evaders, each slower than the pursuer.
    evaders, pursuer
        Strategies: values that come with the package, your own, or plain functions of a
        `Situation`. A name as in scenario files, such as "nearest-first", is the strategy with its
        defaults.
    sensing
        "hidden": the team knows a disk that grows at the pursuer's speed and collapses at each
        capture. "visible": it sees the pursuer at every update.
    update_time
        Δt > 0 between updates; a capture brings an update at once.
    seed
        The same call with the same seed gives the same game, bit for bit.
    time_limit
        Time at which a game is stopped. None: the time by which a pursuer that keeps to any one
        sequence has captured everybody, whatever the team does.
    objective
        What the team maximises and the pursuer minimises, as `covey.plan` takes it. These
        strategies use the objective: `OpenLoop`, `IterativeOpenLoop`, `ConstantHeading`,
        `CommittedPursuer`, `UncommittedPursuer` and `FlyingPursuer`. A pursuer minimises what is
        measured, not its expectation.

    Returns
    -------
    Game
        `planned_value` is the value of the objective by the first plan, `value` the value that was
        reached; `guarantee` and `survival_time` are the same for the last capture.

    Raises
    ------
    InputError
        If an argument can't be used, or a strategy decides what the rules forbid.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> pursuer = covey.FixedSequence([2, 0, 1])
    >>> game = covey.simulate(team, disk, pursuer=pursuer, sensing="hidden")
    >>> game.capture_sequence.tolist()
    [2, 0, 1]
    >>> game.survival_time >= game.guarantee
    True
    """
    settings = checked_settings(team, disk, sensing, update_time, seed, time_limit, objective)
    return build_record(_play(team, disk, evaders, pursuer, settings, recorded=True))


def survival(
    team: Team,
    disk: PursuerDisk,
    *,
    evaders: TeamStrategy | TeamPolicy | str = IterativeOpenLoop(),  # noqa: B008 frozen
    pursuer: PursuerStrategy | PursuerPolicy | str = CommittedPursuer(),  # noqa: B008 frozen
    sensing: str = "hidden",
    update_time: float = 0.01,
    seed: int = 0,
    time_limit: float | None = None,
    objective: Objective | str = LastCapture(),  # noqa: B008 frozen
) -> Outcome:
    """Play the game that `simulate` plays, to the last bit, and keep no record of its course.

    The parameters are those of `simulate`.

    Returns
    -------
    Outcome
        What `Game.outcome()` of the record would be.
    """
    settings = checked_settings(team, disk, sensing, update_time, seed, time_limit, objective)
    return outcome_of(_play(team, disk, evaders, pursuer, settings, recorded=False))


def _play(
    team: Team,
    disk: PursuerDisk,
    evaders: TeamStrategy | TeamPolicy | str,
    pursuer: PursuerStrategy | PursuerPolicy | str,
    settings: Settings,
    *,
    recorded: bool,
) -> Played:
    evaders, pursuer = team_strategy(evaders), pursuer_strategy(pursuer)
    if team_is_built_in(evaders) and pursuer_is_built_in(pursuer):
        return play_compiled(team, disk, evaders, pursuer, settings, recorded=recorded)
    return play_out(Match(team, disk, evaders, pursuer, settings)).played()
