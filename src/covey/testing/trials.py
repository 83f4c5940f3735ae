"""Small games of many kinds, in which a strategy shows its faults."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from covey.model import PursuerDisk, Team


class Trial(NamedTuple):
    """A game, and how it is played."""

    team: Team
    disk: PursuerDisk
    settings: dict[str, Any]


def trials(sensings: Iterable[str]) -> Iterator[Trial]:
    """Return games that differ in size, place, agility, and in what the team sees.

    None is about the origin: a strategy that takes the disk to be there shows it.
    """
    three = Team([(5.3, 2.1), (4.7, 2.4), (5.1, 1.5)], [0.3, 2.0, -1.5], [0.25, 0.2, 0.1])
    agile = Team([(-3.0, 1.0), (-3.5, 1.5)], 0.0, 0.25, math.inf)
    alone = Team([(0.3, -7.0)], 1.0)
    here, there = (5.0, 2.0), (-3.2, 1.2)
    for sensing in sensings:
        settings = {"sensing": sensing, "update_time": 0.2, "seed": 1}
        yield Trial(three, PursuerDisk(here, 0.2), settings)
        yield Trial(agile, PursuerDisk(there, 0.0, capture_radius=0.05), settings)
        yield Trial(alone, PursuerDisk((0.0, -7.0)), settings)
