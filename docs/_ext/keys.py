"""Tables of all keys of a kind of file, made from its JSON schema."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from covey.model.display import angle_text, multiple_of_pi
from covey.scenarios.json_schema import json_schema
from covey.scenarios.schema import ScenarioFile
from covey.studies.design.study_file import StudyFile

MODELS = {"scenario": ScenarioFile, "study": StudyFile}
HEAD = ("key", "meaning", "expected", "unit", "default", "example")


class Keys(SphinxDirective):
    """Every table of a kind of file, and every strategy that has parameters."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return a section for each table."""
        schema = json_schema(MODELS[self.arguments[0]], "")
        found = dict(_tables(schema, schema))
        parts: list[nodes.Node] = []
        for heading, table in {"The top of the file": schema, **found}.items():
            parts += self._section(heading, table)
        return parts

    def _section(self, heading: str, table: dict[str, Any]) -> list[nodes.Node]:
        title = nodes.title("", "", *_in_code(heading))
        section = nodes.section("", title, ids=[nodes.make_id(heading)], names=[heading])
        self.state.document.note_implicit_target(section)
        rows = [_row(key, each, table) for key, each in table["properties"].items()]
        section += _table(HEAD, rows)
        return [section]


def _tables(table: dict[str, Any], schema: dict[str, Any], path: str = "") -> Iterator[Any]:
    """Return each table below a table, by its heading in the file."""
    for key, each in table["properties"].items():
        inner = each.get("items", each)
        if "$ref" in inner:
            below = schema["$defs"][inner["$ref"].rpartition("/")[2]]
            heading = f"{path}{key}"
            yield f"[[{heading}]]" if "items" in each else f"[{heading}]", below
            yield from _tables(below, schema, f"{heading}.")


def _row(key: str, each: dict[str, Any], table: dict[str, Any]) -> list[str]:
    if key in table.get("required", ()):
        default = "must be given"
    else:
        default = f"`{_default(each)}`" if "default" in each else ""
    example = f"`{key} = {_toml(each['examples'][0])}`"
    return [f"`{key}`", each["x-meaning"], each["x-wanted"], each["x-unit"], default, example]


def _default(each: dict[str, Any]) -> str:
    """Write a default as it stands in a file, a simple multiple of π as such."""
    value = each["default"]
    is_angle = each["x-unit"].startswith("radians") and isinstance(value, float)
    return _toml(angle_text(value) if is_angle and multiple_of_pi(value) else value)


def _toml(value: Any) -> str:
    """Write a value as it stands in a file."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_toml(each)}" for key, each in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(round(value, 4) if isinstance(value, float) else value)


def _in_code(text: str) -> list[nodes.Node]:
    """Return a text in which `...` is code."""
    parts = text.split("`")
    kinds = (nodes.Text, lambda part: nodes.literal(part, part))
    return [kinds[index % 2](part) for index, part in enumerate(parts) if part]


def _table(head: tuple[str, ...], rows: list[list[str]]) -> nodes.table:
    """Return a table of texts, in which `...` is code."""
    group = nodes.tgroup(cols=len(head))
    group += [nodes.colspec(colwidth=1) for _ in head]
    group += nodes.thead("", _row_of(head))
    group += nodes.tbody("", *map(_row_of, rows))
    return nodes.table("", group)


def _row_of(cells: list[str] | tuple[str, ...]) -> nodes.row:
    return nodes.row(
        "", *(nodes.entry("", nodes.paragraph("", "", *_in_code(cell))) for cell in cells)
    )


class Names(SphinxDirective):
    """The strategies and objectives that a kind of file knows by name, with their parameters."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return a table with a row for each parameter."""
        schema = json_schema(MODELS[self.arguments[0]], "")
        rows = []
        for name, table in schema["$defs"].items():
            if "name" in table["properties"]:
                own = {key: each for key, each in table["properties"].items() if key != "name"}
                rows += [[f"`{name}`", *_row(key, each, table)[:5]] for key, each in own.items()]
                rows += [] if own else [[f"`{name}`", "", "no parameters", "", "", ""]]
        return [_table(("name", "parameter", "meaning", "expected", "unit", "default"), rows)]


def setup(app: Sphinx) -> dict[str, bool]:
    """Offer the directives."""
    app.add_directive("keys", Keys)
    app.add_directive("names", Names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
