"""What a scenario file may contain: its tables, keys, kinds of value and defaults.

    [pursuer]   center, radius, speed, capture_radius, strategy
    [team]      speed, turn_rate, headings: defaults of all evaders; strategy;
                then one of [[team.evaders]] and [team.random]
    [game]      objective, sensing, update_time, seed, time_limit

A key says nothing about any other here; what must fit together is in `crosschecks`.
"""

from __future__ import annotations

import math
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict

from covey.scenarios.values import (
    AWAY,
    Duration,
    Heading,
    NotNegative,
    Point,
    Positive,
    Rate,
    Whole,
    one_of,
)
from covey.simulation.settings import SENSING


class Section(BaseModel):
    """A table of the file; keys that it doesn't know are mistakes."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class PursuerSection(Section):
    """[pursuer]: the disk that it is in, what it can do, and how it chooses its next target."""

    center: Point = (0.0, 0.0)
    radius: NotNegative = 0.0
    speed: Positive = 1.0
    capture_radius: NotNegative = 0.0
    strategy: Any = "committed"


class EvaderSection(Section):
    """One of [[team.evaders]]; what it leaves out comes from [team]."""

    position: Point
    heading: Heading | None = None
    speed: NotNegative | None = None
    turn_rate: Rate | None = None


class RandomSection(Section):
    """[team.random]: evaders uniformly in a square around the pursuer's centre."""

    count: Whole
    side: Positive = 1.0
    seed: Whole | None = None


class TeamSection(Section):
    """[team]: defaults of all evaders, and where they are."""

    speed: NotNegative = 0.25
    turn_rate: Rate = math.pi / 2
    headings: Heading = AWAY
    strategy: Any = "iterative-open-loop"
    evaders: list[EvaderSection] = []
    random: RandomSection | None = None


class GameSection(Section):
    """[game]: what it is about, and how it is played."""

    objective: Any = "last-capture"
    sensing: Annotated[str, one_of(*SENSING)] = "hidden"
    update_time: Positive = 0.01
    seed: Whole = 0
    time_limit: Duration | None = None


class ScenarioFile(Section):
    """The whole file."""

    pursuer: PursuerSection = PursuerSection()
    team: TeamSection = TeamSection()
    game: GameSection = GameSection()
