"""How close strategies come to the true value of the game, where it is known: two evaders.

Pairs of evaders with simple motion, point capture, a pursuer that is seen; after J. V. Breakwell
and P. Hagedorn, "Point capture of two evaders in succession", J. Optim. Theory Appl. 27 (1979).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, fields
from typing import Any, NamedTuple

import numpy as np

from covey.bounds import TwoEvaderValue, bracket, solve_two_evaders
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors
from covey.model.validation import Floats, whole_number
from covey.players import CommittedPursuer, DownhillPursuer, FixedSequence, survival
from covey.scenarios.strategies import EVADERS
from covey.simulation import PursuerStrategy

SPEEDS = ((0.25, 0.25), (0.5, 0.5), (0.25, 0.5), (0.5, 0.7))
RANDOM, CLOSE = "random", "close"
_FARTHEST_APART = 0.2
"""Of close pairs, relative to the first one's distance from the pursuer."""

_UPDATES = 200
"""In the time that the value is: far more than a policy of two needs."""


class Score(NamedTuple):
    """What a strategy of the evaders made of one start. Times are at pursuer speed 1."""

    speed_1: float
    speed_2: float
    pairs: str
    pair: int
    x_1: float
    y_1: float
    x_2: float
    y_2: float
    value: float
    lower: float  # of the bracket
    upper: float
    evaders: str
    survival_time: float  # the least against four pursuers
    pursuer: str  # that one of them


class Change(NamedTuple):
    """By how much, relative, values moved from a grid of half as many cells to this one."""

    speed_1: float
    speed_2: float
    pairs: str
    cells: int
    mean: float
    most: float


class Yardstick(NamedTuple):
    """Scores of all strategies and the changes of the value, for one couple of speeds."""

    scores: list[Score]
    changes: list[Change]


def default_evaders() -> dict[str, Any]:
    """Return every strategy of the evaders that comes with covey and needs no parameter."""
    return {
        name: entry.make()
        for name, entry in EVADERS.items()
        if all(field.default is not MISSING for field in fields(entry.make))  # type: ignore[arg-type]
    }


def measure(
    speeds: tuple[float, float],
    *,
    pairs: int = 50,
    cells: int = 256,
    seed: int = 0,
    evaders: Mapping[str, Any] | None = None,
) -> Yardstick:
    """Play strategies against the true value of the game of two evaders.

    Parameters
    ----------
    speeds
        Of the two, relative to the pursuer's.
    pairs
        Starts of each kind: uniform in a unit square around the pursuer, and close to each other,
        at most a fifth of their distance from it apart.
    cells
        Of the grid of the value, see `covey.planning.solve_two_evaders`; those of a half and of a
        quarter are computed too.
    seed
        Of the starts and of the strategies.
    evaders
        Strategies by their names; by default all that come with covey and need no parameter.

    Returns
    -------
    Yardstick
        The survival time of a strategy is the least against four pursuers: downhill on the value,
        the committed one, and the two that keep to an order.
    """
    whole_number("pairs", pairs, low=1)
    starts = {kind: _starts(kind, pairs, seed) for kind in (RANDOM, CLOSE)}
    values = [solve_two_evaders(speeds, cells=cells // share) for share in (4, 2, 1)]
    changes = [
        _change(speeds, kind, coarse, fine, places)
        for kind, places in starts.items()
        for coarse, fine in ((values[0], values[1]), (values[1], values[2]))
    ]
    chosen = default_evaders() if evaders is None else evaders
    scores = [
        score
        for kind, places in starts.items()
        for pair, place in enumerate(places)
        for score in _scores(values[-1], kind, pair, place, chosen, seed)
    ]
    return Yardstick(scores, changes)


def _starts(kind: str, pairs: int, seed: int) -> Floats:
    """Return places (pairs, 2, 2) of the evaders, the pursuer in the origin."""
    generator = np.random.default_rng((seed, kind == CLOSE))
    places = generator.uniform(-0.5, 0.5, (pairs, 2, 2))
    if kind == CLOSE:
        away = generator.uniform(0.0, _FARTHEST_APART, pairs) * np.hypot(*places[:, 0].T)
        bearing = generator.uniform(-math.pi, math.pi, pairs)
        off = away[:, np.newaxis] * unit_vectors(bearing)
        places[:, 1] = places[:, 0] + off
    return places


def _change(
    speeds: tuple[float, float],
    kind: str,
    coarse: TwoEvaderValue,
    fine: TwoEvaderValue,
    places: Floats,
) -> Change:
    moved = np.abs(coarse.at(places) / fine.at(places) - 1.0)
    return Change(*speeds, kind, len(fine.shares) - 1, float(moved.mean()), float(moved.max()))


def _scores(
    value: TwoEvaderValue,
    kind: str,
    pair: int,
    places: Floats,
    evaders: Mapping[str, Any],
    seed: int,
) -> Iterator[Score]:
    team = Team(places, np.zeros(2), value.speeds, math.inf)
    disk = PursuerDisk()
    true, bounds = value.of(team, disk), bracket(team, disk, seed=seed)
    (v1, v2), (x1, y1, x2, y2) = value.speeds.tolist(), places.ravel().tolist()
    pursuers: dict[str, PursuerStrategy] = {
        "downhill": DownhillPursuer(value),
        "committed": CommittedPursuer(),
        "0 first": FixedSequence((0, 1)),
        "1 first": FixedSequence((1, 0)),
    }
    for name, strategy in evaders.items():
        times = {
            who: survival(
                team,
                disk,
                evaders=strategy,
                pursuer=pursuer,
                sensing="visible",
                update_time=true / _UPDATES,
                seed=seed,
            ).survival_time
            for who, pursuer in pursuers.items()
        }
        worst = min(times, key=lambda who: times[who])
        lower, upper = bounds.lower, bounds.upper
        yield Score(
            v1, v2, kind, pair, x1, y1, x2, y2, true, lower, upper, name, times[worst], worst
        )
