"""Strategies and objectives by their name in a file, or by a table with name and parameters.

strategy = "committed"
strategy = { name = "committed", margin = 0.05 }
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, reduce
from inspect import Parameter, signature
from operator import or_
from typing import Annotated, Any, Literal

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, ValidationError, create_model
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, core_schema

from covey.model import objectives
from covey.players import names
from covey.scenarios.about import TIME, About
from covey.scenarios.values.kinds import (
    AtLeastOne,
    Margin,
    NotNegative,
    Offset,
    Sequence,
    Sequences,
    Weights,
    Whole,
)
from covey.scenarios.values.value_types import UNKNOWN_NAME, Section, one_of, one_of_words, wanted


@dataclass(frozen=True)
class Entry:
    """A strategy or objective, and the type of each of its parameters."""

    make: Callable[..., Any]
    parameters: Mapping[str, Any]

    def table(self, name: str) -> type[Section]:
        """Return the model of the table that gives this name and the parameters."""
        defaults = {
            key: ... if each.default is Parameter.empty else each.default
            for key, each in signature(self.make).parameters.items()
        }
        keys: Any = {key: (kind, defaults[key]) for key, kind in self.parameters.items()}
        return create_model(name, __base__=Section, **{"name": (Literal[name], ...), **keys})


PARAMETERS: Mapping[str, Any] = {
    "starts": Annotated[AtLeastOne, About("Starts of the search for the first plan.", 32)],
    "restarts": Annotated[Whole, About("Starts of a later search, beside the plan flown.", 8)],
    "depth": Annotated[Whole, About("How many captures are answered; by default all.", 1)],
    "replan_time": Annotated[
        NotNegative, About("Time between two plans; 0: at every update.", 0.1, TIME)
    ],
    "margin": Annotated[
        Margin, About("By which share another sequence must be better to be taken.", 0.05)
    ],
    "offset": Annotated[
        Offset, About("Start of the pursuer, from the centre, in radii of the disk.", [0.5, 0.0])
    ],
    "sequence": Annotated[
        Sequence, About("The order of capture; by default as the strategy chooses.", [2, 0, 1])
    ],
    "sequences": Annotated[
        Sequences,
        About("Sequences that may be drawn; by default all.", [[0, 1, 2], [2, 1, 0]]),
    ],
    "weights": Annotated[
        Weights, About("Weight of each sequence; by default all are equal.", [3.0, 1.0])
    ],
    "measure": Annotated[
        str,
        one_of(*objectives.MEASURES),
        About("Of what the mean is taken: the last capture, or the sum.", "last"),
    ],
}
"""The type of each parameter of a strategy or objective."""


def _entries(known: Mapping[str, Callable[..., Any]]) -> dict[str, Entry]:
    return {
        name: Entry(make, {key: PARAMETERS[key] for key in signature(make).parameters})
        for name, make in known.items()
    }


EVADERS, PURSUERS = _entries(names.TEAMS), _entries(names.PURSUERS)
OBJECTIVES = _entries(objectives.OBJECTIVES)


_NAMED = "a name, or a table with a name and parameters"


@dataclass(frozen=True, eq=False)
class Named:
    """A type of value: one of the entries, by name or by a table, or a value of one's own."""

    known: Mapping[str, Entry]

    @cached_property
    def tables(self) -> dict[str, type[Section]]:
        """The model of the table of each name."""
        return {name: entry.table(name) for name, entry in self.known.items()}

    def __get_pydantic_core_schema__(
        self, _source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Make pydantic read values of this type with `read` alone."""
        written = reduce(or_, self.tables.values(), Literal[tuple(self.known)])
        return core_schema.no_info_plain_validator_function(
            self.read, json_schema_input_schema=handler.generate_schema(written)
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Describe the type in words too."""
        return {**handler(schema), "description": _NAMED}

    def read(self, value: Any) -> Any:
        """Return the strategy or objective; raise all mistakes of its table."""
        if not isinstance(value, str | dict):
            if callable(value) or hasattr(value, "describe") or hasattr(value, "start"):
                return value
            raise wanted(_NAMED)
        name, given = _split(value)
        if not isinstance(name, str) or name not in self.known:
            raise self._unknown(name, isinstance(value, dict))
        self.tables[name].model_validate({**given, "name": name})
        return self.known[name].make(**given)

    def _unknown(self, name: object, in_table: bool) -> ValidationError:
        context = {"words": one_of_words(self.known), "known": list(self.known)}
        error = PydanticCustomError(UNKNOWN_NAME, "{words}", context)
        where = ("name",) if in_table else ()
        details = InitErrorDetails(type=error, loc=where, input=name)
        return ValidationError.from_exception_data("name", [details])


def _split(value: str | dict[str, Any]) -> tuple[object, dict[str, Any]]:
    """Return the name and the parameters."""
    if isinstance(value, str):
        return value, {}
    return value.get("name"), {key: each for key, each in value.items() if key != "name"}
