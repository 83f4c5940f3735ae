"""How close strategies of two evaders come to the true value of their game, which is known.

The evaders turn at once and see the pursuer; the capture radius is 0. The value is after
J. V. Breakwell and P. Hagedorn, "Point capture of two evaders in succession", J. Optim. Theory
Appl. 27 (1979).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, fields
from itertools import pairwise
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
_MAX_SEPARATION = 0.2
"""Of a close pair, relative to the first evader's distance from the pursuer."""

_UPDATES = 200
"""Updates in a time as long as the value. A team of two needs far fewer."""


class YardstickRow(NamedTuple):
    """The result of one strategy of the evaders from one start. Times are at pursuer speed 1."""

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
    pursuer: str  # the one of them that was fastest


class Change(NamedTuple):
    """Relative change of the value from a grid of half as many cells to this grid."""

    speed_1: float
    speed_2: float
    pairs: str
    cells: int
    mean: float
    most: float


class Yardstick(NamedTuple):
    """Rows of all strategies and changes of the value, at one couple of speeds."""

    rows: list[YardstickRow]
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
    """Play strategies, and compare their survival times with the value of the game.

    Parameters
    ----------
    speeds
        Of the two evaders, relative to the pursuer's.
    pairs
        Starts of each kind, at least 1. Random pairs are uniform in a unit square around the
        pursuer. Close pairs are at most a fifth of their distance from the pursuer apart.
    cells
        Of the finest grid of the value, see `covey.bounds.solve_two_evaders`. Grids of a half and
        of a quarter of them are solved too.
    seed
        Of the starts and of the strategies.
    evaders
        Strategies by their names; by default `default_evaders`.

    Returns
    -------
    Yardstick
        The survival time of a strategy is the least against four pursuers: downhill on the value,
        the committed one, and the two fixed orders of capture.
    """
    whole_number("pairs", pairs, low=1)
    strategies = default_evaders() if evaders is None else evaders
    starts = {kind: _draw_pairs(kind, pairs, seed) for kind in (RANDOM, CLOSE)}
    values = [solve_two_evaders(speeds, cells=cells // share) for share in (4, 2, 1)]
    return Yardstick(
        [
            row
            for kind, positions in starts.items()
            for pair, each in enumerate(positions)
            for row in _rows(values[-1], (kind, pair), each, strategies, seed)
        ],
        [
            _change(kind, positions, coarse, fine)
            for kind, positions in starts.items()
            for coarse, fine in pairwise(values)
        ],
    )


def _draw_pairs(kind: str, pairs: int, seed: int) -> Floats:
    """Return positions (pairs, 2, 2) of the evaders; the pursuer is in the origin."""
    generator = np.random.default_rng((seed, kind == CLOSE))
    positions = generator.uniform(-0.5, 0.5, (pairs, 2, 2))
    if kind == CLOSE:
        ranges = np.hypot(*positions[:, 0].T)
        distances = generator.uniform(0.0, _MAX_SEPARATION, pairs) * ranges
        bearings = generator.uniform(-math.pi, math.pi, pairs)
        units = unit_vectors(bearings)
        positions[:, 1] = positions[:, 0] + distances[:, np.newaxis] * units
    return positions


def _change(kind: str, positions: Floats, coarse: TwoEvaderValue, fine: TwoEvaderValue) -> Change:
    moved = np.abs(coarse.at(positions) / fine.at(positions) - 1.0)
    (v1, v2), cells = fine.speeds.tolist(), len(fine.shares) - 1
    return Change(v1, v2, kind, cells, float(moved.mean()), float(moved.max()))


def _rows(
    value: TwoEvaderValue,
    start: tuple[str, int],
    positions: Floats,
    evaders: Mapping[str, Any],
    seed: int,
) -> Iterator[YardstickRow]:
    team, disk = Team(positions, np.zeros(2), value.speeds, math.inf), PursuerDisk()
    true, bounds = value.of(team, disk), bracket(team, disk, depth=0, seed=seed)
    (v1, v2), (x1, y1, x2, y2) = value.speeds.tolist(), positions.ravel().tolist()
    known = (v1, v2, *start, x1, y1, x2, y2, true, bounds.lower, bounds.upper)
    pursuers: dict[str, PursuerStrategy] = {
        "downhill": DownhillPursuer(value),
        "committed": CommittedPursuer(),
        "0 first": FixedSequence((0, 1)),
        "1 first": FixedSequence((1, 0)),
    }
    settings: dict[str, Any] = {"sensing": "visible", "update_time": true / _UPDATES, "seed": seed}
    for name, strategy in evaders.items():
        times = {
            word: survival(team, disk, evaders=strategy, pursuer=each, **settings).survival_time
            for word, each in pursuers.items()
        }
        fastest = min(times, key=lambda word: times[word])
        yield YardstickRow(*known, name, times[fastest], fastest)
