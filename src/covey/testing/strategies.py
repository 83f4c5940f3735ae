"""`check_strategy`: what is wrong with a strategy, before it plays in earnest."""

from __future__ import annotations

from collections.abc import Mapping
from copy import deepcopy
from typing import Any

import numpy as np

from covey.model import InputError
from covey.model.validation import choice, shown
from covey.players import simulate
from covey.players.names import pursuer_strategy, team_strategy
from covey.simulation import PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy
from covey.simulation.settings import SENSING
from covey.testing.trials import Trial, trials
from covey.testing.watched import Watched

_OPPONENTS = {"evaders": {"pursuer": "nearest-first"}, "pursuer": {"evaders": "straight-away"}}


def check_strategy(
    *,
    evaders: TeamStrategy | TeamPolicy | str | None = None,
    pursuer: PursuerStrategy | PursuerPolicy | str | None = None,
    sensing: str | None = None,
) -> None:
    """Play small games with a strategy, and say what is wrong with it and what to do.

    Parameters
    ----------
    evaders, pursuer
        One of the two: the strategy, as `covey.simulate` takes it.
    sensing
        "hidden" or "visible", for a strategy that is made for one of them. Default: both are tried.

    Raises
    ------
    InputError
        At the first fault. The message says which rule is broken, when, and what to do.

    Notes
    -----
    The games are of one to three evaders, with a hidden pursuer and a visible one, with and without
    a limit to the turn rates. Each is played twice with the same seed. The check finds

    - classes in place of values, and a `start` or a policy that can't be called;
    - exceptions, and situations that are changed;
    - turns that aren't one number in [-π, π] for each evader alive;
    - moves that aren't a `Chase` of living evaders or a `Fly` within the pursuer's speed;
    - decisions that depend on chance without the seed, or on games played before;
    - a `place` outside the disk, and a `describe` without a name.

    Examples
    --------
    >>> import covey
    >>> def keep_on(situation):
    ...     return [0.0] * len(situation.evaders)
    >>> covey.testing.check_strategy(evaders=keep_on)
    """
    role, strategy = _only_one(evaders, pursuer)
    _check_description(role, strategy)
    for trial in trials(SENSING if sensing is None else [choice("sensing", sensing, SENSING)]):
        fresh = _copied(strategy)
        first, second = (_decisions(role, strategy, trial) for _ in range(2))
        if not _same(first, second):
            raise InputError(f"{role}: {_difference(role, strategy, fresh, trial, first)}")


def _copied(strategy: Any) -> Any:
    """Return a copy of a strategy before it plays; itself where it can't be copied."""
    try:
        return deepcopy(strategy)
    except Exception:  # what a lock or a module raises, or a method of the strategy's own
        return strategy


def _only_one(evaders: object, pursuer: object) -> tuple[str, Any]:
    if (evaders is None) == (pursuer is None):
        came = "neither" if evaders is None else "both"
        raise InputError(f"evaders, pursuer: expected one of them to be checked, got {came}")
    if evaders is None:
        return "pursuer", pursuer_strategy(pursuer)  # type: ignore[arg-type]
    return "evaders", team_strategy(evaders)  # type: ignore[arg-type]


def _check_description(role: str, strategy: object) -> None:
    if isinstance(strategy, type) or not hasattr(strategy, "describe"):
        return
    described = strategy.describe()
    if not isinstance(described, Mapping) or not isinstance(described.get("name"), str):
        raise InputError(
            f"{role}: describe() returned {shown(described)}; return a mapping with a name and "
            "the parameters, or leave the method out"
        )


def _decisions(role: str, strategy: object, trial: Trial) -> list[Any]:
    """Play a game, and return all decisions."""
    watched = Watched(role, strategy)
    players: dict[str, Any] = {role: watched, **_OPPONENTS[role]}
    simulate(trial.team, trial.disk, **players, **trial.settings)
    return watched.decisions


def _same(first: list[Any], second: list[Any]) -> bool:
    return len(first) == len(second) and all(map(np.array_equal, first, second))


def _difference(role: str, strategy: object, fresh: object, trial: Trial, first: list[Any]) -> str:
    """Say why two games with the same seed were not the same."""
    what = "the same game with the same seed was played differently the second time; "
    if not hasattr(strategy, "start"):
        return what + (
            "a function decides the same in the same situation; for memory or chance write a class "
            "whose start(seed) returns the policy of one game"
        )
    if _same(first, _decisions(role, fresh, trial)):
        return what + "keep what is remembered in the policy that start(seed) makes for each game"
    return what + "draw random numbers from numpy.random.default_rng(seed), in start(seed)"
