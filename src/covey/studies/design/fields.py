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
    Rate,
    Section,
    TeamSize,
    Whole,
    one_of,
)
from covey.simulation.settings import SENSING
from covey.studies.design.as_visible import AsVisible
from covey.studies.design.consistency import inconsistencies
from covey.studies.design.start_table import FromFile
from covey.studies.design.study import GRID, Study, plain

_HEADINGS = Annotated[str, one_of(*HEADINGS)]
_SHAPE = Annotated[str, one_of(*SHAPES)]

SAMPLERS = {
    "square": Entry(Square, {"side": Positive, "headings": _HEADINGS}),
    "disk": Entry(Disk, {"radius": Positive, "headings": _HEADINGS}),
    "formation": Entry(Formation, {"shape": _SHAPE, "spacing": Positive, "distance": NotNegative}),
    "file": Entry(FromFile, {"path": FileName}),
}
STUDY_PURSUERS = {**PURSUERS, "as-visible": Entry(AsVisible, {"margin": Margin})}

_TYPES: dict[str, Any] = {
    "starts": AtLeastOne,
    "seed": Whole,
    "sampler": Annotated[Any, Named(SAMPLERS)],
    "trajectories": Flag,
    "team_size": OneOrMany[TeamSize],
    "speed": OneOrMany[NotNegative],
    "turn_rate": OneOrMany[Rate],
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


def _table(name: str, keys: Iterable[str], **tables: Any) -> type[Section]:
    """Return the model of a table of these fields, with the defaults of `Study`."""
    typed: dict[str, Any] = {
        key: (_TYPES[key], Field(plain(getattr(Study, key)), validate_default=True)) for key in keys
    }
    return create_model(name, __base__=Section, **typed, **tables)


GridTable = _table("GridTable", GRID)
StudyFile = _table(
    "StudyFile",
    [key for key in _TYPES if key not in GRID],
    grid=(GridTable, Field(default_factory=GridTable)),
)


def read_fields(document: Mapping[str, Any]) -> tuple[dict[str, Any], list[Mistake]]:
    """Return the values of all fields from the tables of a study file, and all mistakes there."""
    try:
        file = StudyFile.model_validate(document)
    except ValidationError as error:
        return {}, list(mistakes_of(error, StudyFile, document))
    values = dict(file)
    values |= dict(values.pop("grid"))
    return values, list(inconsistencies(values))
