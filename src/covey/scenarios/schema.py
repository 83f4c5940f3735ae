"""What a scenario file may contain: its tables, keys, types of value and defaults.

    [pursuer]   center and radius, or last_seen; speed, capture_radius, strategy
    unit        of lengths; times are in seconds then
    [team]      speed, turn_rate or turn_radius, heading: defaults of all evaders; strategy;
                then one of [[team.evaders]] and [team.random]
    [game]      objective, sensing, update_time, seed, time_limit

Each key is checked by itself here. What must fit together is in `consistency`.
"""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import AliasChoices, Field

from covey.model.team import DEFAULT_TURN_RATE
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PURSUERS, Named
from covey.scenarios.values import (
    AWAY,
    Duration,
    Heading,
    NotNegative,
    Point,
    Positive,
    Radius,
    Rate,
    Section,
    UnitName,
    Whole,
    one_of,
)
from covey.simulation.settings import SENSING


class LastSeenSection(Section):
    """[pursuer.last_seen]: the disk is within + speed · ago around the position."""

    position: Point
    within: NotNegative = 0.0
    ago: NotNegative


class PursuerSection(Section):
    """[pursuer]: its disk, speed and reach, and the strategy that chooses its next target."""

    center: Point = (0.0, 0.0)
    radius: NotNegative = 0.0
    last_seen: LastSeenSection | None = None
    speed: Positive = 1.0
    capture_radius: NotNegative = 0.0
    strategy: Annotated[Any, Named(PURSUERS)] = Field(default="committed", validate_default=True)


class EvaderSection(Section):
    """One of [[team.evaders]]; keys left out come from [team]."""

    position: Point
    heading: Heading | None = None
    speed: NotNegative | None = None
    turn_rate: Rate | None = None
    turn_radius: Radius | None = None


class RandomSection(Section):
    """[team.random]: evaders uniformly in a square around the pursuer's centre."""

    count: Whole
    side: Positive = 1.0
    seed: Whole | None = None


class TeamSection(Section):
    """[team]: defaults of all evaders, and where they are."""

    speed: NotNegative = 0.25
    turn_rate: Rate = DEFAULT_TURN_RATE
    turn_radius: Radius | None = None
    heading: Heading = Field(default=AWAY, validation_alias=AliasChoices("heading", "headings"))
    strategy: Annotated[Any, Named(EVADERS)] = Field(
        default="iterative-open-loop", validate_default=True
    )
    evaders: list[EvaderSection] = Field(default_factory=list)
    random: RandomSection | None = None


class GameSection(Section):
    """[game]: its objective, and how it is played."""

    objective: Annotated[Any, Named(OBJECTIVES)] = Field(
        default="last-capture", validate_default=True
    )
    sensing: Annotated[str, one_of(*SENSING)] = "hidden"
    update_time: Positive = 0.01
    seed: Whole = 0
    time_limit: Duration | None = None


class ScenarioFile(Section):
    """The whole file. Where `unit` names the unit of lengths, times are in seconds."""

    unit: UnitName = ""
    pursuer: PursuerSection = Field(default_factory=PursuerSection)
    team: TeamSection = Field(default_factory=TeamSection)
    game: GameSection = Field(default_factory=GameSection)
