"""How long a team's strategy survives in a game of the set, against four pursuers."""

from __future__ import annotations

from typing import NamedTuple

from covey.instances.instance import Instance
from covey.players import CommittedPursuer, FixedSequence, survival
from covey.simulation import PursuerStrategy, TeamPolicy, TeamStrategy
from covey.simulation.settings import SENSING

_UPDATES = 200
"""Updates in a time as long as the plan guarantees."""


class Score(NamedTuple):
    """What came of one game.

    Attributes
    ----------
    instance : str
        The name of the game.
    sensing : str
        "hidden" or "visible".
    pursuer : str
        "worst-sequence", which keeps to the order that is worst for the best plan known, or
        "committed".
    survival_time : float
        Time of the last capture.
    share : float
        The same, relative to what the best plan known guarantees.

    Examples
    --------
    >>> import covey
    >>> game = covey.load_instance("paper-2")
    >>> scores = covey.instances.score(game, "open-loop")
    >>> [(score.sensing, score.pursuer) for score in scores][:2]
    [('hidden', 'worst-sequence'), ('hidden', 'committed')]
    """

    instance: str
    sensing: str
    pursuer: str
    survival_time: float
    share: float


def score(
    instance: Instance, evaders: TeamStrategy | TeamPolicy | str, *, seed: int = 0
) -> list[Score]:
    """Play a team's strategy in a game of the set against four pursuers.

    Parameters
    ----------
    instance
        See `covey.load_instance`.
    evaders
        The strategy, as `covey.simulate` takes it.
    seed
        Of the strategies.

    Returns
    -------
    list of Score
        Two pursuers, each visible and hidden. The least share is what the strategy is worth: 1 and
        more for every team that keeps the guarantee of the best plan known.

    Examples
    --------
    >>> import covey
    >>> game = covey.load_instance("paper-2")
    >>> scores = covey.instances.score(game, "straight-away")
    >>> round(min(score.share for score in scores), 2)
    0.96
    """
    pursuers: dict[str, PursuerStrategy] = {
        "worst-sequence": FixedSequence(instance.plan.worst_sequence),
        "committed": CommittedPursuer(),
    }
    guaranteed = instance.plan.survival_time
    scores = []
    for sensing in SENSING:
        for name, pursuer in pursuers.items():
            time = survival(
                instance.team,
                instance.disk,
                evaders=evaders,
                pursuer=pursuer,
                sensing=sensing,
                update_time=guaranteed / _UPDATES,
                seed=seed,
            ).survival_time
            scores.append(Score(instance.name, sensing, name, time, time / guaranteed))
    return scores
