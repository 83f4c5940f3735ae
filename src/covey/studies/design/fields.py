"""The fields of a study, the type of each, and what a study file is made of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Annotated, Any

from pydantic import Field, ValidationError, create_model

from covey.scenarios.mistakes import Mistake, mistakes_of
from covey.scenarios.samplers import HEADINGS, SHAPES, Disk, Formation, Square
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PURSUERS, Entry, Named
from covey.scenarios.values import (
    AtLeastOne,
    FileName,
    Flag,
    Margin,
    NotNegative,
    OneOrMany,
    Positive,
    Radius,
    Rate,
    Section,
    TeamSize,
    Whole,
    one_of,
)
from covey.simulation.settings import SENSING
from covey.studies.design.as_visible import VISIBLE_PURSUERS, AsVisible
from covey.studies.design.case import GRID
from covey.studies.design.consistency import inconsistencies
from covey.studies.design.start_table import FromFile

_HEADINGS = Annotated[str, one_of(*HEADINGS)]
_SHAPE = Annotated[str, one_of(*SHAPES)]

SAMPLERS = {
    "square": Entry(Square, {"side": Positive, "headings": _HEADINGS}),
    "disk": Entry(Disk, {"radius": Positive, "headings": _HEADINGS}),
    "formation": Entry(Formation, {"shape": _SHAPE, "spacing": Positive, "distance": NotNegative}),
    "file": Entry(FromFile, {"path": FileName}),
}
_VISIBLE_PURSUER = Annotated[str, one_of(*VISIBLE_PURSUERS)]
STUDY_PURSUERS = {
    **PURSUERS,
    "as-visible": Entry(AsVisible, {"margin": Margin, "pursuer": _VISIBLE_PURSUER}),
}

_TYPES: dict[str, Any] = {
    "starts": AtLeastOne,
    "seed": Whole,
    "sampler": Annotated[Any, Named(SAMPLERS)],
    "trajectories": Flag,
    "team_size": OneOrMany[TeamSize],
    "speed": OneOrMany[NotNegative],
    "turn_rate": OneOrMany[Rate] | None,
    "turn_radius": OneOrMany[Radius] | None,
    "pursuer_speed": OneOrMany[Positive],
    "disk_radius": OneOrMany[NotNegative],
    "capture_radius": OneOrMany[NotNegative],
    "update_time": OneOrMany[Positive],
    "sensing": OneOrMany[Annotated[str, one_of(*SENSING)]],
    "objective": OneOrMany[Annotated[Any, Named(OBJECTIVES)]],
    "evaders": OneOrMany[Annotated[Any, Named(EVADERS)]],
    "pursuer": OneOrMany[Annotated[Any, Named(STUDY_PURSUERS)]],
}
"""The type of each field of `Study`."""


def study_model(defaults: Mapping[str, Any]) -> type[Section]:
    """Return the model of a study file; fields without a default must be given."""
    grid = create_model("GridTable", __base__=Section, **_typed(GRID, defaults))
    top = _typed([key for key in _TYPES if key not in GRID], defaults)
    return create_model(
        "StudyFile", __base__=Section, **top, grid=(grid, Field(default_factory=grid))
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
