"""How a value of a file is read. Each type of value says in words what is wanted.

All mistakes are answered with these words. The types themselves stand in `values`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from covey.model.validation import LARGEST

WANTED = "wanted"
"""Type of the error of a value; its context gives `words`, what was wanted."""
UNKNOWN_NAME = "unknown_name"
"""Type of the error of a name; its context gives the names `known` too."""


class Section(BaseModel):
    """A table of a file; unknown keys are mistakes."""

    model_config = ConfigDict(extra="forbid", frozen=True)


def wanted(words: str) -> PydanticCustomError:
    """Return the error of a value that isn't what was wanted."""
    # Braces in the message itself would be taken for a place in a template.
    return PydanticCustomError(WANTED, "{words}", {"words": words})


def one_of_words(allowed: Iterable[str]) -> str:
    """Return in words that one of these names is wanted."""
    return "one of " + ", ".join(f'"{name}"' for name in allowed)


@dataclass(frozen=True, eq=False)
class ValueType:
    """A type of value: in words, and a function that reads a value or returns None.

    `written` is what may stand in the file where that is more than the values read. `limits` are
    the words in JSON schema, as far as they can be said there.
    """

    words: str
    read: Callable[[Any], object | None]
    written: Any = None
    limits: Mapping[str, Any] = field(default_factory=dict)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Make pydantic read values of this type with `read` alone."""
        written = handler.generate_schema(self.written or source)
        return core_schema.no_info_plain_validator_function(
            self._check, json_schema_input_schema=written
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Describe the type in words too."""
        return {**handler(schema), **self.limits, "description": self.words}

    def _check(self, value: Any) -> object:
        plain = value.item() if getattr(value, "ndim", None) == 0 else value  # a NumPy number
        result = self.read(plain)
        if result is None:
            raise wanted(_SIZE if _is_too_large(plain) else self.words)
        return result


_SIZE = f"a number of at most {LARGEST:g} in size"


def _is_too_large(value: object) -> bool:
    return isinstance(value, int | float) and LARGEST < abs(value) < math.inf


def one_of(*allowed: str) -> ValueType:
    """Return the type of value that is one of these words."""
    return ValueType(
        one_of_words(allowed),
        lambda value: value if value in allowed else None,
        written=Literal[allowed],
    )
