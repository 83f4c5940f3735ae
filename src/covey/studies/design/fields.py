"""The fields of a study, the type of each, and what a study file is made of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Annotated, Any

from pydantic import Field, ValidationError, create_model

from covey.scenarios.about import LENGTH, SPEED, TIME, TURN_RATE, UNIT, About
from covey.scenarios.mistakes import Mistake, mistakes_of
from covey.scenarios.samplers import HEADINGS, SHAPES, Disk, Formation, Square
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PARAMETERS, PURSUERS, Entry, Named
from covey.scenarios.values.kinds import (
    AtLeastOne,
    FileName,
    Flag,
    NotNegative,
    Positive,
    Radius,
    Rate,
    TeamSize,
    UnitName,
    Whole,
)
from covey.scenarios.values.one_or_many import OneOrMany
from covey.scenarios.values.value_types import Section, one_of
from covey.simulation.settings import SENSING
from covey.studies.design.as_visible import VISIBLE_PURSUERS, AsVisible
from covey.studies.design.case import GRID
from covey.studies.design.consistency import inconsistencies
from covey.studies.design.start_table import FromFile

_SIDE = Annotated[Positive, About("Side of the square.", 1.0, LENGTH)]
_RADIUS = Annotated[Positive, About("Radius of the disk.", 0.5, LENGTH)]
_HEADINGS = Annotated[str, one_of(*HEADINGS), About("Initial headings.", "away")]
_SHAPE = Annotated[str, one_of(*SHAPES), About("Shape of the formation.", SHAPES[0])]
_SPACING = Annotated[Positive, About("Distance of neighbours.", 0.1, LENGTH)]
_DISTANCE = Annotated[
    NotNegative, About("Distance of the formation from the pursuer.", 0.5, LENGTH)
]
_PATH = Annotated[FileName, About("Table of starts, as CSV or Parquet.", "starts.csv")]

SAMPLERS = {
    "square": Entry(Square, {"side": _SIDE, "headings": _HEADINGS}),
    "disk": Entry(Disk, {"radius": _RADIUS, "headings": _HEADINGS}),
    "formation": Entry(Formation, {"shape": _SHAPE, "spacing": _SPACING, "distance": _DISTANCE}),
    "file": Entry(FromFile, {"path": _PATH}),
}
_VISIBLE_PURSUER = Annotated[
    str, one_of(*VISIBLE_PURSUERS), About("The pursuer of the visible game.", VISIBLE_PURSUERS[0])
]
STUDY_PURSUERS = {
    **PURSUERS,
    "as-visible": Entry(AsVisible, {"margin": PARAMETERS["margin"], "pursuer": _VISIBLE_PURSUER}),
}

_TYPES: dict[str, Any] = {
    "starts": Annotated[AtLeastOne, About("How many starts.", 500)],
    "seed": Annotated[Whole, About("Seed of the starts.", 1)],
    "sampler": Annotated[
        Any,
        Named(SAMPLERS),
        About("How starts are drawn.", {"name": "square", "side": 1.0, "headings": "away"}),
    ],
    "trajectories": Annotated[Flag, About("Whether the course of every game is kept.", True)],
    "unit": Annotated[UnitName, UNIT],
    "team_size": Annotated[OneOrMany[TeamSize], About("Number of evaders.", [3, 5])],
    "speed": Annotated[OneOrMany[NotNegative], About("Speed of every evader.", 0.25, SPEED)],
    "turn_rate": Annotated[
        OneOrMany[Rate] | None,
        About("Largest turn rate of every evader; by default pi/2.", ["pi/2", "pi"], TURN_RATE),
    ],
    "turn_radius": Annotated[
        OneOrMany[Radius] | None,
        About("Least turning radius of every evader, in place of the turn rate.", 0.16, LENGTH),
    ],
    "pursuer_speed": Annotated[OneOrMany[Positive], About("Speed of the pursuer.", 1.0, SPEED)],
    "disk_radius": Annotated[
        OneOrMany[NotNegative], About("Radius of the disk around the origin.", 0.1, LENGTH)
    ],
    "capture_radius": Annotated[
        OneOrMany[NotNegative], About("Capture radius of the pursuer.", 0.02, LENGTH)
    ],
    "update_time": Annotated[
        OneOrMany[Positive], About("Time between two updates.", [0.01, 0.05], TIME)
    ],
    "sensing": Annotated[
        OneOrMany[Annotated[str, one_of(*SENSING)]],
        About("Whether the team sees the pursuer.", ["hidden", "visible"]),
    ],
    "objective": Annotated[
        OneOrMany[Annotated[Any, Named(OBJECTIVES)]],
        About("What the games are about.", "last-capture"),
    ],
    "evaders": Annotated[
        OneOrMany[Annotated[Any, Named(EVADERS)]],
        About("Strategies of the team.", ["open-loop", "iterative-open-loop"]),
    ],
    "pursuer": Annotated[
        OneOrMany[Annotated[Any, Named(STUDY_PURSUERS)]],
        About("Strategies of the pursuer.", "committed"),
    ],
}
"""The type of each field of `Study`."""


def study_model(defaults: Mapping[str, Any]) -> type[Section]:
    """Return the model of a study file; fields without a default must be given."""
    grid = create_model("GridTable", __base__=Section, **_typed(GRID, defaults))
    top = _typed([key for key in _TYPES if key not in GRID], defaults)
    varied: Any = Annotated[grid, About("What the games vary in.", {"team_size": [3, 5]})]
    return create_model(
        "StudyFile",
        __base__=Section,
        **top,
        grid=(varied, Field(default_factory=grid)),
    )


def _typed(keys: Iterable[str], defaults: Mapping[str, Any]) -> dict[str, Any]:
    """Return type and default of some fields."""
    return {
        key: (_TYPES[key], Field(defaults.get(key, ...), validate_default=True)) for key in keys
    }


ALL_GIVEN = study_model({})
"""The model of the arguments of `Study`, none of which is left out."""


def read_fields(
    document: Mapping[str, Any], model: type[Section]
) -> tuple[dict[str, Any], list[Mistake]]:
    """Return the values of all fields from the tables of a study file, and all mistakes there."""
    try:
        file = model.model_validate(document)
    except ValidationError as error:
        return {}, list(mistakes_of(error, model, document))
    values = dict(file)
    values |= dict(values.pop("grid"))
    return values, list(inconsistencies(values))
