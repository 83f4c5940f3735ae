"""Mistakes in a file: where, what was wanted, what came, and what was probably meant."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, NamedTuple, TypeGuard, get_args, get_origin

from pydantic import ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from covey.model import InputError
from covey.model.units import counted
from covey.scenarios.strategies import Named
from covey.scenarios.values import value_types
from covey.scenarios.values.one_or_many import is_single
from covey.scenarios.values.value_types import Section, ValueType

KeyPath = tuple[str | int, ...]
"""Keys and indices that lead to a value: ("team", "evaders", 2, "speed")."""

_LONGEST_VALUE = 60
_MOST_TOLD = 10


class Mistake(NamedTuple):
    """One mistake; `text` says what was wanted and what came."""

    path: KeyPath
    text: str

    def __str__(self) -> str:
        """Return the line that a person reads."""
        return f"{path_text(self.path)}: {self.text}"


def path_text(path: KeyPath) -> str:
    """Write a path as one would look for it: team.evaders[2].speed; long keys shortened."""
    text = "".join(f"[{key}]" if isinstance(key, int) else f".{_shortened(key)}" for key in path)
    return text.removeprefix(".")


def require_none(mistakes: Sequence[Mistake], path: Path) -> None:
    """Raise InputError with the first mistakes of a file, one a line, if there are any."""
    if mistakes:
        told = [str(mistake) for mistake in mistakes[:_MOST_TOLD]]
        rest = len(mistakes) - len(told)
        more = [f"and {rest} more"] if rest else []
        raise InputError(
            "\n  ".join([f"{path}: {counted(len(mistakes), 'mistake')}", *told, *more])
        )


def wanted_but_got(wanted: str, value: object) -> str:
    """Say what was wanted and what came."""
    return f"expected {wanted}, got {toml_text(value)}"


def toml_text(value: object) -> str:
    """Write a value as it might stand in the file, shortened."""
    if isinstance(value, str):
        text = json.dumps(value, ensure_ascii=False)
    elif isinstance(value, bool):
        text = str(value).lower()
    elif isinstance(value, list | tuple):
        text = "[" + ", ".join(toml_text(part) for part in value) + "]"
    elif isinstance(value, Mapping):
        text = "a table" + (f" with {', '.join(value)}" if value else " with nothing in it")
    else:
        text = str(value)
    return _shortened(text)


def _shortened(text: str) -> str:
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 3] + "..."


def did_you_mean(word: object, known: Iterable[str]) -> str:
    """Return '; did you mean "speed"?', or nothing when no known word is close."""
    close = _closest(word, known)
    return f'; did you mean "{close}"?' if close else ""


def _closest(word: object, known: Iterable[str]) -> str | None:
    return next(iter(get_close_matches(str(word).lower(), known, n=1)), None)


def look(document: Any, *path: str | int, default: Any = None) -> Any:
    """Return the value at a path of the document; `default` if there is none."""
    try:
        for key in path:
            document = document[key]
    except (KeyError, TypeError, IndexError):  # absent, or below a value that isn't a table
        return default
    return document


def mistakes_of(error: ValidationError, file: type[Section], document: Any) -> Iterator[Mistake]:
    """Translate what pydantic found in a document; a missing key that was misspelt is told once."""
    layout = _Layout(file, document)
    found = [(layout.written(detail["loc"]), detail) for detail in error.errors(include_url=False)]
    misspelt = {
        (*path[:-1], _closest(path[-1], layout.table(path[:-1]).model_fields))
        for path, detail in found
        if detail["type"] == "extra_forbidden"
    }
    for path, detail in found:
        if detail["type"] != "missing" or path not in misspelt:
            yield Mistake(path, _text(path, detail, layout))


def _text(path: KeyPath, detail: ErrorDetails, layout: _Layout) -> str:
    value, context = detail["input"], detail.get("ctx", {})
    match detail["type"]:
        case "extra_forbidden":
            return _unknown_key(path, layout)
        case "missing":
            return f"missing; expected {layout.words(path)}"
        case "value_error":  # of what is read already
            return str(context["error"])
        case value_types.WANTED:
            return wanted_but_got(context["words"], value)
        case value_types.UNKNOWN_NAME:
            came = "nothing" if value is None else toml_text(value)
            return f"expected {context['words']}, got {came}{did_you_mean(value, context['known'])}"
        case "list_type":
            return wanted_but_got(f"a list of tables, [[{path_text(path)}]]", value)
    return wanted_but_got("a table", value)


def _unknown_key(path: KeyPath, layout: _Layout) -> str:
    key, known = str(path[-1]), layout.table(path[:-1]).model_fields
    homes = " or ".join(title for title, table in layout.tables() if key in table.model_fields)
    hint = did_you_mean(key, known) + (f'; "{key}" belongs to {homes}' if homes else "")
    return "unknown key" + (hint or f"; known here: {', '.join(known)}")


class _Layout(NamedTuple):
    """What the models of a file say about the paths of a document."""

    file: type[Section]
    document: Any

    def written(self, path: KeyPath) -> KeyPath:
        """Drop the index of a value that stands in the document instead of a list of one."""
        kept: KeyPath = ()
        for key in path:
            if isinstance(key, str) or not is_single(look(self.document, *kept)):
                kept = (*kept, key)
        return kept

    def table(self, path: KeyPath) -> type[Section]:
        """Return the model of the table at a path."""
        for part in _parts(self._field(path)) if path else (self.file,):
            if _is_table(part):
                return part
            if isinstance(part, Named):
                return part.tables[look(self.document, *path)["name"]]
        raise LookupError(path)

    def words(self, path: KeyPath) -> str:
        """Return in words the type of the value at a path."""
        parts = _parts(self._field(path))
        return next(part.words for part in parts if isinstance(part, ValueType))

    def tables(self) -> Iterator[tuple[str, type[Section]]]:
        """Return all tables of the file, each with its heading."""
        yield "the top of the file", self.file
        yield from _tables_below(self.file)

    def _field(self, path: KeyPath) -> FieldInfo:
        while isinstance(path[-1], int):
            path = path[:-1]
        return self.table(path[:-1]).model_fields[path[-1]]


def _tables_below(parent: type[Section], path: KeyPath = ()) -> Iterator[tuple[str, type[Section]]]:
    for key, field in parent.model_fields.items():
        heading, parts = f"[{path_text((*path, key))}]", list(_parts(field))
        for table in filter(_is_table, parts):
            yield f"[{heading}]" if list in {get_origin(part) for part in parts} else heading, table
            yield from _tables_below(table, (*path, key))


def _parts(field: FieldInfo) -> Iterator[Any]:
    """Return the annotation of a field, the types in it, and what is known of each."""
    yield from field.metadata
    yield from _parts_of(field.annotation)


def _parts_of(annotation: Any) -> Iterator[Any]:
    yield annotation
    for part in get_args(annotation):
        yield from _parts_of(part)


def _is_table(part: Any) -> TypeGuard[type[Section]]:
    return isinstance(part, type) and issubclass(part, Section)
