"""What the reference and editors say of a key of a file: its meaning, an example, its unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from pydantic import GetJsonSchemaHandler
from pydantic_core import CoreSchema

LENGTH, TIME, SPEED = "length", "time", "length/time"
ANGLE, TURN_RATE = "radians", "radians/time"
"""Units of keys. Lengths and times are in any consistent unit."""


@dataclass(frozen=True)
class About:
    """Describes a key, in JSON schema too.

    `limits` hold for the key alone, beside those of its type of value.
    """

    meaning: str
    example: Any
    unit: str = ""
    limits: Mapping[str, Any] = field(default_factory=dict)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Add the description, which editors show, and its parts."""
        described = handler(schema)
        tables = "a list of tables" if "items" in described else "a table"
        words = described.pop("description", tables)
        return {
            **described,
            **self.limits,
            "description": f"{self.meaning} Expected: {words}.",
            "examples": [self.example],
            "x-meaning": self.meaning,
            "x-unit": self.unit,
            "x-wanted": words,
        }


UNIT = About("Unit of lengths, which is then printed; times are in seconds.", "m")
"""Of the key `unit`, which scenarios and studies share."""
