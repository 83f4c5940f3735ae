"""Study files: TOML in, with all its mistakes told at once, and a study out.

starts, seed, sampler, trajectories
[grid]      team_size, speed, turn_rate, pursuer_speed, disk_radius, capture_radius,
            update_time, sensing, objective, evaders, pursuer: each a value or a list of values
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from covey.model import InputError
from covey.scenarios.load import read_document
from covey.scenarios.mistakes import Mistake, Place, require_none, unknown_key, wanted_but_got
from covey.studies.design.fields import FIELDS
from covey.studies.design.study import GRID, Study

_FOLDER = Path(__file__).parents[1] / "examples"
_OWN = [name for name in FIELDS if name not in GRID]


def example_names() -> list[str]:
    """Return the names of the studies that come with the package."""
    return sorted(path.stem for path in _FOLDER.glob("*.toml"))


def example_path(name: str) -> Path:
    """Return the file of a study that comes with the package."""
    return _FOLDER / f"{name}.toml"


def read_study(path: str | os.PathLike[str]) -> Study:
    """Read a study from its TOML file.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    InputError
        If the file can't be read, or with all of its mistakes, one a line: the place, what was
        wanted, what came.
    """
    file = Path(path)
    values, mistakes = _read(read_document(file, "a study"))
    require_none(mistakes, file)
    try:
        return Study(**values)
    except InputError as error:  # what is right by itself may not fit together
        raise InputError(f"{file}: {str(error).removeprefix('study: ')}") from None


def _read(document: Mapping[str, Any]) -> tuple[dict[str, Any], list[Mistake]]:
    values: dict[str, Any] = {}
    mistakes: list[Mistake] = []
    for place, value in _entries(document, mistakes):
        values[str(place[-1])], found = FIELDS[str(place[-1])].read(place, value)
        mistakes += found
    return values, mistakes


def _entries(
    document: Mapping[str, Any], mistakes: list[Mistake]
) -> Iterator[tuple[Place, object]]:
    """Return the known entries of the file; note the others as mistakes."""
    grid = document.get("grid", {})
    if not isinstance(grid, dict):
        mistakes.append(Mistake(("grid",), wanted_but_got("a table", grid)))
        grid = {}
    tables = (
        ((), {k: v for k, v in document.items() if k != "grid"}, _OWN),
        (("grid",), grid, GRID),
    )
    for place, table, known in tables:
        for key, value in table.items():
            if key in known:
                yield (*place, key), value
            elif key in FIELDS:
                home = "the top of the file" if key in _OWN else "[grid]"
                text = f"unknown key here; it belongs to {home}"
                mistakes.append(Mistake((*place, key), text))
            else:
                mistakes.append(unknown_key((*place, key), known))
