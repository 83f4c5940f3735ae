"""What came of a game, without its record: what studies of many games need."""

from __future__ import annotations

import math
from typing import NamedTuple

from covey.model import LastCapture, Objective, PursuerDisk, Team, objective_value
from covey.model.validation import Floats, Ints
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


class Outcome(NamedTuple):
    """What came of a game.

    Attributes
    ----------
    guarantee : float
        Survival time that the first plan guaranteed.
    survival_time : float
        Time of the last capture; inf if the game was stopped before it.
    planned_value, value : float
        What the first plan made of the objective, and what came of it.
    capture_sequence, capture_times : numpy.ndarray
        (C,) evaders in the order of their capture, and when.
    """

    guarantee: float
    survival_time: float
    planned_value: float
    value: float
    capture_sequence: Ints
    capture_times: Floats


def outcome_of(game: Game) -> Outcome:
    """Return the outcome that a record tells of."""
    return Outcome(
        game.guarantee,
        game.survival_time,
        game.planned_value,
        game.value,
        game.capture_sequence,
        game.capture_times,
    )


def survival(
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
) -> Outcome:
    """Play the game that `simulate` plays, to the last bit, and keep no record of its course.

    Parameters
    ----------
    team, disk, evaders, pursuer, sensing, update_time, seed, time_limit, objective
        See `simulate`.

    Returns
    -------
    Outcome
        What the record of the game would say.
    """
    settings = checked_settings(team, disk, sensing, update_time, seed, time_limit, objective)
    if not (team_is_built_in(evaders) and pursuer_is_built_in(pursuer)):
        return outcome_of(play(team, disk, evaders, pursuer, settings))
    played = play_compiled(team, disk, evaders, pursuer, settings, recorded=False)
    ended = len(played.times) == len(team)
    return Outcome(
        played.plan.survival_time,
        float(played.times[-1]) if ended else math.inf,
        played.plan.value,
        objective_value(objective, played.times) if ended else math.inf,
        played.order,
        played.times,
    )
