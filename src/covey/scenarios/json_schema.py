"""The JSON schema of a kind of file, by which editors complete it and check it."""

from __future__ import annotations

from typing import Any

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from covey.scenarios.values.value_types import Section

_DIALECT = "https://json-schema.org/draft/2020-12/schema"


class _TomlSchema(GenerateJsonSchema):
    """TOML has no null: a key that may be None may be left out."""

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        """Describe the value that is not None."""
        return self.generate_inner(schema["schema"])

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        """Leave out the default None."""
        if schema.get("default") is None:
            return self.generate_inner(schema["schema"])
        return super().default_schema(schema)


def json_schema(file: type[Section], title: str) -> dict[str, Any]:
    """Return the JSON schema of the files that a model reads.

    It knows of every key, type of value and range. It can't say what must fit together: that
    evaders are slower than the pursuer, for example.
    """
    schema = file.model_json_schema(schema_generator=_TomlSchema)
    return {"$schema": _DIALECT, **schema, "title": title}
