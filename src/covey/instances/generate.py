"""How the states of all games came about: `python -m covey.instances.generate` writes `games/`.

Each family is a function of the number of evaders. Speeds and turn rates are those of section V of
the paper, 0.25 and π/2, and evaders fly straight away from the pursuer, where nothing else is said.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from covey.instances.files import instance_path
from covey.instances.text import game_text
from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors
from covey.model.validation import Floats

_Game = tuple[Team, PursuerDisk]
_GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))


class Family(NamedTuple):
    """Games of one kind."""

    about: str
    make: Callable[[int], _Game]
    sizes: tuple[int, ...]


def _in_square(n: int, kind: int = 0) -> Floats:
    """Return positions (n, 2), uniform in the unit square; each kind has draws of its own."""
    return np.random.default_rng((kind, n)).uniform(-0.5, 0.5, (n, 2))


def _away(
    positions: Floats,
    disk: PursuerDisk = PursuerDisk(),  # noqa: B008 frozen
    **numbers: Any,
) -> _Game:
    return Team(positions, disk.headings_away(positions), **numbers), disk


def _paper(n: int) -> _Game:
    return _away(_in_square(n))


def _turning_at(turn_rate: float) -> Callable[[int], _Game]:
    return lambda n: _away(_in_square(n), turn_rates=turn_rate)


def _headings(n: int) -> _Game:
    headings = np.random.default_rng((1, n)).uniform(-math.pi, math.pi, n)
    return Team(_in_square(n), headings), PursuerDisk()


def _mixed(n: int) -> _Game:
    generator = np.random.default_rng((2, n))
    positions = generator.uniform(-0.5, 0.5, (n, 2))
    headings = generator.uniform(-math.pi, math.pi, n)
    speeds = generator.uniform(0.1, 0.5, n)
    turn_rates = generator.choice([math.pi / 4, math.pi / 2, 2 * math.pi, math.inf], n)
    return Team(positions, headings, speeds, turn_rates), PursuerDisk()


def _disk(n: int) -> _Game:
    return _away(_in_square(n, 3), PursuerDisk(radius=0.15))


def _reach(n: int) -> _Game:
    return _away(_in_square(n, 4), PursuerDisk(capture_radius=0.02))


def _seen(n: int) -> _Game:
    """Return vehicles in metres and seconds, and a pursuer that was last seen 12 s ago."""
    disk = PursuerDisk.last_seen(
        (2000.0, -1000.0), within=150.0, ago=12.0, speed=45.0, capture_radius=5.0, unit="m"
    )
    positions = disk.center + 3000.0 * _in_square(n, 5)
    return _away(positions, disk, speeds=20.0, turn_radii=60.0, unit="m")


def _circle(n: int) -> _Game:
    return _away(0.5 * unit_vectors(2.0 * math.pi * np.arange(n) / n))


def _line(n: int) -> _Game:
    positions = np.column_stack([np.linspace(-0.5, 0.5, n), np.full(n, 0.25)])
    return Team(positions, math.pi / 2), PursuerDisk()


def _grid(n: int) -> _Game:
    side = math.isqrt(n)
    steps = (np.arange(side) + 0.5) / side - 0.5
    return _away(np.array([(x, y + 0.75) for x in steps for y in steps]))


def _clusters(n: int) -> _Game:
    """Return clusters of about five, 0.5 from the pursuer, each 0.05 across."""
    count = -(-n // 5)
    centers = 0.5 * unit_vectors(2.0 * math.pi * np.arange(count) / count)
    return _away(centers[np.arange(n) % count] + 0.05 * _in_square(n, 6))


def _coincident(n: int) -> _Game:
    """Return evaders at one position, with headings all around."""
    return Team(np.full((n, 2), 0.3), _GOLDEN_ANGLE * np.arange(n)), PursuerDisk()


def _pairs(n: int) -> _Game:
    """Return two evaders at each position, equal in everything."""
    return _away(np.repeat(_in_square(n // 2, 7), 2, axis=0))


def _one_fast(n: int) -> _Game:
    return _away(_in_square(n, 8), speeds=[0.9, *[0.2] * (n - 1)])


FAMILIES = {
    "paper": Family(
        "Evaders uniform in the unit square around the pursuer, as in section V.B of the paper",
        _paper,
        (2, 3, 4, 5, 6, 8, 10, 12, 14, 15, 17, 20, 25, 30, 40, 50),
    ),
    "sluggish": Family(
        "As the games paper-*, with turn rate pi/4", _turning_at(math.pi / 4), (5, 12)
    ),
    "agile": Family("As the games paper-*, with turn rate 2 pi", _turning_at(2 * math.pi), (5, 12)),
    "simple": Family(
        "As the games paper-*, with simple motion: evaders turn at once",
        _turning_at(math.inf),
        (2, 5, 12),
    ),
    "headings": Family("As the games paper-*, with headings at random", _headings, (8, 20)),
    "mixed": Family(
        "Evaders with positions, headings, speeds and turn rates at random",
        _mixed,
        (3, 5, 8, 12, 20, 30, 50),
    ),
    "disk": Family(
        "Evaders uniform in the unit square around a pursuer in a disk of radius 0.15",
        _disk,
        (2, 5, 8, 12, 20, 30),
    ),
    "reach": Family(
        "Evaders uniform in the unit square around a pursuer with capture radius 0.02",
        _reach,
        (3, 5, 8, 12, 20, 30),
    ),
    "seen": Family(
        "Vehicles of 20 m/s that turn within 60 m; a pursuer of 45 m/s and reach 5 m, last seen "
        "12 s ago",
        _seen,
        (4, 10),
    ),
    "circle": Family("Evaders evenly on a circle around the pursuer", _circle, (6, 12, 20, 30, 50)),
    "line": Family(
        "Evaders evenly on a line beside the pursuer, who fly away from the line",
        _line,
        (8, 15, 30, 50),
    ),
    "grid": Family("Evaders on a square grid beside the pursuer", _grid, (9, 16, 25, 49)),
    "clusters": Family(
        "Clusters of about five evaders around the pursuer", _clusters, (10, 30, 40)
    ),
    "coincident": Family("Evaders at one position, with headings all around", _coincident, (4, 10)),
    "pairs": Family("Pairs of evaders that are equal in everything", _pairs, (6, 12, 30)),
    "one-fast": Family(
        "Evaders uniform in the unit square: one of speed 0.9, the others of 0.2",
        _one_fast,
        (3, 8, 15, 30),
    ),
}
"""All games of the set."""


def games() -> Iterator[tuple[str, str, Team, PursuerDisk]]:
    """Return each game's name, what it is, and its state."""
    for name, family in FAMILIES.items():
        for n in family.sizes:
            yield f"{name}-{n}", family.about, *family.make(n)


def main() -> None:
    """Write the states of all games."""
    for name, about, team, disk in games():
        instance_path(name).write_text(game_text(about, team, disk), encoding="utf-8")


if __name__ == "__main__":
    main()
