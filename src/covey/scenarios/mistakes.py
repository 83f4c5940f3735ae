"""Mistakes in a scenario file: where, what was wanted, what came, and what was probably meant."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, NamedTuple, get_args

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from covey.model import InputError
from covey.scenarios.schema import ScenarioFile
from covey.scenarios.values import WANTED, Wanted

Place = tuple[str | int, ...]
"""Keys and positions that lead to a value: ("team", "evaders", 2, "speed")."""

_LONGEST_VALUE = 60


class Mistake(NamedTuple):
    """One mistake; `text` says what was wanted and what came."""

    place: Place
    text: str

    def __str__(self) -> str:
        """Return the line that a person reads."""
        return f"{place_text(self.place)}: {self.text}"


def place_text(place: Place) -> str:
    """Write a place as one would look for it: team.evaders[2].speed."""
    text = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in place)
    return text.removeprefix(".")


def require_none(mistakes: Sequence[Mistake], path: Path) -> None:
    """Raise InputError with all mistakes of a file, one a line, if there are any."""
    if mistakes:
        count = "1 mistake" if len(mistakes) == 1 else f"{len(mistakes)} mistakes"
        raise InputError("\n  ".join([f"{path}: {count}", *map(str, mistakes)]))


def wanted_but_got(wanted: str, value: object) -> str:
    """Say what was wanted and what came."""
    return f"expected {wanted}, got {toml_text(value)}"


def toml_text(value: object) -> str:
    """Write a value as it might stand in the file, shortened."""
    if isinstance(value, str):
        text = json.dumps(value, ensure_ascii=False)
    elif isinstance(value, bool):
        text = str(value).lower()
    elif isinstance(value, list):
        text = "[" + ", ".join(toml_text(part) for part in value) + "]"
    elif isinstance(value, Mapping):
        text = "a table" + (f" with {', '.join(value)}" if value else " with nothing in it")
    else:
        text = str(value)
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 3] + "..."


def did_you_mean(word: object, known: Iterable[str]) -> str:
    """Return '; did you mean "speed"?', or nothing when no known word is close."""
    close = _closest(word, known)
    return f'; did you mean "{close}"?' if close else ""


def _closest(word: object, known: Iterable[str]) -> str | None:
    return next(iter(get_close_matches(str(word).lower(), known, n=1)), None)


def unknown_key(place: Place, known: Iterable[str], homes: Iterable[str] = ()) -> Mistake:
    """Return the mistake of a key that isn't known at its place, but in the tables `homes`."""
    names, tables = list(known), " or ".join(homes)
    hint = did_you_mean(place[-1], names)
    if tables:
        hint += f'; "{place[-1]}" belongs to {tables}'
    return Mistake(place, "unknown key" + (hint or f"; known here: {', '.join(names)}"))


def mistakes_of(error: ValidationError) -> Iterator[Mistake]:
    """Translate what pydantic found; a missing key that was only misspelt is told once."""
    found = error.errors(include_url=False)
    unknown = [detail["loc"] for detail in found if detail["type"] == "extra_forbidden"]
    misspelt = {(*place[:-1], _closest(place[-1], _fields(place[:-1]))) for place in unknown}
    for detail in found:
        if detail["type"] != "missing" or detail["loc"] not in misspelt:
            yield _mistake(detail)


def _mistake(detail: ErrorDetails) -> Mistake:
    place, kind = detail["loc"], detail["type"]
    if kind == "extra_forbidden":
        homes = [table for table, names in _tables() if str(place[-1]) in names]
        return unknown_key(place, _fields(place[:-1]), homes)
    if kind == "missing":
        wanted = _wanted(place)
        return Mistake(place, "missing" + (f"; expected {wanted}" if wanted else ""))
    if kind == WANTED:
        return Mistake(place, wanted_but_got(detail["msg"], detail["input"]))
    wanted = "a list of tables, [[team.evaders]]" if kind == "list_type" else "a table"
    return Mistake(place, wanted_but_got(wanted, detail["input"]))


def _tables() -> Iterator[tuple[str, Iterable[str]]]:
    for table in ("[pursuer]", "[team]", "[[team.evaders]]", "[team.random]", "[game]"):
        place = tuple(table.strip("[]").split("."))
        yield table, _fields(place)


def _model(place: Place) -> type[BaseModel]:
    """Return the model of the table at `place`."""
    model: type[BaseModel] = ScenarioFile
    for key in place:
        if isinstance(key, str):
            model = _section_in(model.model_fields[key].annotation)
    return model


def _section_in(annotation: Any) -> type[BaseModel]:
    """Find the model in `EvaderSection`, `list[EvaderSection]` or `RandomSection | None`."""
    for part in (annotation, *get_args(annotation)):
        if isinstance(part, type) and issubclass(part, BaseModel):
            return part
    raise TypeError(annotation)


def _fields(place: Place) -> list[str]:
    return list(_model(place).model_fields)


def _wanted(place: Place) -> str:
    """Return in words the kind of value that belongs to the key at `place`."""
    kinds = _model(place[:-1]).model_fields[str(place[-1])].metadata
    return next((kind.words for kind in kinds if isinstance(kind, Wanted)), "")
