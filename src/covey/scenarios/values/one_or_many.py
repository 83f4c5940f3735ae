"""Keys of a study file that take one value, or a list of different ones."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Annotated, Any, TypeVar

from pydantic import AfterValidator, BeforeValidator, GetJsonSchemaHandler, ValidationError
from pydantic_core import CoreSchema, InitErrorDetails

from covey.model import InputError
from covey.scenarios.values.value_types import wanted


def is_single(value: object) -> bool:
    """Tell a single value from a list of values."""
    return isinstance(value, str | Mapping) or not isinstance(value, Iterable)


def _as_several(value: Any) -> tuple[Any, ...]:
    values = (value,) if is_single(value) else tuple(value)
    if not values:
        raise wanted("a value or a list of values")
    return values


def _require_different(values: tuple[Any, ...]) -> tuple[Any, ...]:
    twice = [index for index, value in enumerate(values) if value in values[:index]]
    if twice:
        error = {"error": InputError("given twice")}
        details = [
            InitErrorDetails(type="value_error", loc=(index,), input=values[index], ctx=error)
            for index in twice
        ]
        raise ValidationError.from_exception_data("list", details)
    return values


class _SingleToo:
    """Lets the JSON schema of a list accept one value instead."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        several = handler(schema)
        words = several["items"].get("description", "a value")
        return {
            "anyOf": [several["items"], {**several, "minItems": 1, "uniqueItems": True}],
            "description": f"{words}; or a list of different ones",
        }


_Value = TypeVar("_Value")

OneOrMany = Annotated[
    tuple[_Value, ...],
    BeforeValidator(_as_several),
    AfterValidator(_require_different),
    _SingleToo(),
]
"""One value, or a list of different ones."""
