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

from pydantic import AliasChoices, ConfigDict, Field
from pydantic.config import JsonDict

from covey.kernels.arrays import MOST_EVADERS
from covey.model.team import DEFAULT_TURN_RATE
from covey.scenarios.about import ANGLE, LENGTH, SPEED, TIME, TURN_RATE, UNIT, About
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PURSUERS, Named
from covey.scenarios.values.kinds import (
    AWAY,
    Duration,
    Heading,
    NotNegative,
    Point,
    Positive,
    Radius,
    Rate,
    UnitName,
    Whole,
)
from covey.scenarios.values.value_types import Section, one_of
from covey.simulation.settings import SENSING

_NOT_BOTH_TURNS: JsonDict = {"not": {"required": ["turn_rate", "turn_radius"]}}


class LastSeenSection(Section):
    """[pursuer.last_seen]: the disk is within + speed · ago around the position."""

    position: Annotated[Point, About("Where the pursuer was seen.", [0, 0], LENGTH)]
    within: Annotated[NotNegative, About("By how much the position may be wrong.", 150, LENGTH)] = (
        0.0
    )
    ago: Annotated[NotNegative, About("How long ago that was.", 12, TIME)]


class PursuerSection(Section):
    """[pursuer]: its disk, speed and reach, and the strategy that chooses its next target."""

    model_config = ConfigDict(
        json_schema_extra={
            "dependentSchemas": {
                "last_seen": {
                    "not": {"anyOf": [{"required": [key]} for key in ("center", "radius")]}
                }
            }
        }
    )

    center: Annotated[
        Point, About("Centre of the disk in which the pursuer is.", [0, 0], LENGTH)
    ] = (0.0, 0.0)
    radius: Annotated[
        NotNegative,
        About("Radius of that disk; 0 where the team knows the position.", 690, LENGTH),
    ] = 0.0
    last_seen: Annotated[
        LastSeenSection | None,
        About(
            "A last sighting, in place of the centre and the radius.",
            {"position": [0, 0], "within": 150, "ago": 12},
        ),
    ] = None
    speed: Annotated[Positive, About("Largest speed of the pursuer.", 45, SPEED)] = 1.0
    capture_radius: Annotated[
        NotNegative, About("Distance at which the pursuer captures an evader.", 5, LENGTH)
    ] = 0.0
    strategy: Annotated[
        Any, Named(PURSUERS), About("How the pursuer chooses its next target.", "committed")
    ] = Field(default="committed", validate_default=True)


class EvaderSection(Section):
    """One of [[team.evaders]]; keys left out come from [team]."""

    model_config = ConfigDict(json_schema_extra=_NOT_BOTH_TURNS)

    position: Annotated[Point, About("Where the evader is.", [900, 300], LENGTH)]
    heading: Annotated[Heading | None, About("Its heading.", "180 deg", ANGLE)] = None
    speed: Annotated[
        NotNegative | None, About("Its speed, below that of the pursuer.", 25, SPEED)
    ] = None
    turn_rate: Annotated[Rate | None, About("Its largest turn rate.", "19 deg", TURN_RATE)] = None
    turn_radius: Annotated[
        Radius | None, About("Its least turning radius, in place of the turn rate.", 40, LENGTH)
    ] = None


class RandomSection(Section):
    """[team.random]: evaders uniformly in a square around the pursuer's centre."""

    count: Annotated[
        Whole,
        About("How many evaders.", 4, limits={"minimum": 1, "maximum": MOST_EVADERS}),
    ]
    side: Annotated[Positive, About("Side of the square.", 2000, LENGTH)] = 1.0
    seed: Annotated[
        Whole | None, About("Seed of the positions; by default the seed of [game].", 1)
    ] = None


class TeamSection(Section):
    """[team]: defaults of all evaders, and where they are."""

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [{"required": ["evaders"]}, {"required": ["random"]}],
            **_NOT_BOTH_TURNS,
        }
    )

    speed: Annotated[NotNegative, About("Speed of every evader.", 20, SPEED)] = 0.25
    turn_rate: Annotated[Rate, About("Largest turn rate of every evader.", "19 deg", TURN_RATE)] = (
        DEFAULT_TURN_RATE
    )
    turn_radius: Annotated[
        Radius | None,
        About("Least turning radius of every evader, in place of the turn rate.", 60, LENGTH),
    ] = None
    heading: Annotated[
        Heading,
        About(
            'Heading of every evader; "away": straight away from the centre of the disk.',
            "away",
            ANGLE,
        ),
    ] = Field(default=AWAY, validation_alias=AliasChoices("heading", "headings"))
    strategy: Annotated[
        Any, Named(EVADERS), About("How the team plans.", "iterative-open-loop")
    ] = Field(default="iterative-open-loop", validate_default=True)
    evaders: Annotated[
        list[EvaderSection],
        About(
            "The evaders, a table [[team.evaders]] for each.",
            [{"position": [900, 300]}],
            limits={"minItems": 1, "maxItems": MOST_EVADERS},
        ),
    ] = Field(default_factory=list)
    random: Annotated[
        RandomSection | None,
        About("Evaders at random positions, in place of the list.", {"count": 4}),
    ] = None


class GameSection(Section):
    """[game]: its objective, and how it is played."""

    objective: Annotated[
        Any, Named(OBJECTIVES), About("What the game is about.", "last-capture")
    ] = Field(default="last-capture", validate_default=True)
    sensing: Annotated[
        str,
        one_of(*SENSING),
        About("Whether the team sees the pursuer at every update.", "visible"),
    ] = "hidden"
    update_time: Annotated[Positive, About("Time between two updates.", 0.5, TIME)] = 0.01
    seed: Annotated[Whole, About("Seed of the searches for plans.", 1)] = 0
    time_limit: Annotated[
        Duration | None,
        About("When a game is stopped; by default long enough for every capture.", 1000, TIME),
    ] = None


class ScenarioFile(Section):
    """The whole file. Where `unit` names the unit of lengths, times are in seconds."""

    model_config = ConfigDict(json_schema_extra={"required": ["team"]})

    unit: Annotated[UnitName, UNIT] = ""
    pursuer: Annotated[PursuerSection, About("The pursuer.", {"speed": 45})] = Field(
        default_factory=PursuerSection
    )
    team: Annotated[TeamSection, About("The team.", {"speed": 20, "random": {"count": 4}})] = Field(
        default_factory=TeamSection
    )
    game: Annotated[GameSection, About("How the game is played.", {"sensing": "hidden"})] = Field(
        default_factory=GameSection
    )
