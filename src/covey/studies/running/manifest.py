"""The manifest of a results folder: the study, the versions of the code, the machine."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from covey.kernels.arrays import MOST_EVADERS
from covey.model import InputError, LastCapture
from covey.model.validation import choice, shown, unit_name, whole_number
from covey.scenarios.values.angles import Angle
from covey.simulation.files import whole_file
from covey.simulation.settings import SENSING
from covey.studies.design.case import GRID
from covey.studies.design.study import Study, flattened
from covey.studies.running.chunks import chunks_of, starts_per_chunk
from covey.studies.running.parts import Extent
from covey.studies.running.provenance import machine, versions
from covey.studies.running.tables import described_text

FORMAT = 1
NAME = "manifest.json"
_LONGEST_VALUE = 100


def manifest_of(study: Study) -> dict[str, Any]:
    """Return the manifest of a study that is played by this code on this machine."""
    manifest = {
        "format": FORMAT,
        "study": study.describe(),
        "typed": _typed(study),
        "seed": study.seed,
        "games": study.games,
        "cases": len(study.cases),
        "parts": {"count": len(chunks_of(study)), "starts_per_part": starts_per_chunk(study)},
        "versions": versions(),
        "machine": machine(),
    }
    # As a reader will get it: JSON turns tuples into lists.
    read: dict[str, Any] = json.loads(json.dumps(manifest))
    return read


def _typed(study: Study) -> dict[str, list[str]]:
    """Return the values of those fields of the grid of which some were given as angles in words."""
    grid = {name: getattr(study, name) or () for name in GRID}
    return {
        name: [str(value) for value in values]
        for name, values in grid.items()
        if any(isinstance(value, Angle) for value in values)
    }


def write_manifest(folder: Path, manifest: Mapping[str, Any]) -> None:
    """Write the manifest, whole or not at all."""
    with whole_file(folder / NAME) as file:
        file.write((json.dumps(manifest, indent=2, ensure_ascii=False) + "\n").encode())


def read_manifest(folder: Path) -> dict[str, Any] | None:
    """Return the manifest of a folder, or None if the folder has none."""
    path = folder / NAME
    try:
        content: Any = json.loads(path.read_bytes())
    except FileNotFoundError:
        return None
    except OSError as error:
        raise InputError(f"{path}: can't be read: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path}: expected the manifest of a study, got {error}") from error
    manifest: dict[str, Any] = content if isinstance(content, dict) else {}
    if manifest.get("format") != FORMAT:
        raise InputError(
            f"{path}: expected the manifest of a study in format {FORMAT}, "
            f"got format {shown(manifest.get('format'))}"
        )
    try:
        _complete(manifest)
        _require_counts(manifest)
        _require_grid(manifest["study"]["grid"])
        _require_typed(manifest["study"]["grid"], manifest["typed"])
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise InputError(f"{path}: the manifest of the study is damaged: {error}") from error
    return manifest


def extent_of(manifest: Mapping[str, Any], number: int) -> Extent:
    """Return the games of the part of a number."""
    cases, games = manifest["cases"], manifest["games"]
    step = manifest["parts"]["starts_per_part"] * cases
    grid = manifest["study"]["grid"]
    one_objective = all(each["name"] == "last-capture" for each in grid["objective"])
    last = min((number + 1) * step, games)
    return Extent(number * step, last, cases, max(grid["team_size"]), one_objective)


def _complete(manifest: dict[str, Any]) -> None:
    """Add what early versions did not write down: they knew one objective, no radii, no units."""
    grid = manifest["study"]["grid"]
    manifest["study"].setdefault("unit", "")
    grid.setdefault("objective", [LastCapture().describe()])
    grid.setdefault("turn_radius", [None])
    manifest.setdefault("typed", {})


def _require_counts(manifest: Mapping[str, Any]) -> None:
    """Raise any error unless the numbers of cases, games and parts follow from the study."""
    study, parts = manifest["study"], manifest["parts"]
    cases = math.prod(len(study["grid"][name]) for name in GRID)
    starts, step = whole_number("starts", study["starts"], low=1), parts["starts_per_part"]
    wanted = [cases, cases * starts, math.ceil(starts / whole_number("step", step, low=1))]
    came = [manifest["cases"], manifest["games"], parts["count"]]
    if came != wanted or cases == 0:
        raise ValueError(f"expected cases, games, parts to be {wanted}, got {shown(came)}")
    if not isinstance(study["trajectories"], bool) or not isinstance(manifest["versions"], dict):
        raise TypeError("expected trajectories: true or false, versions: a table")
    unit_name("unit", study["unit"])


def _require_grid(grid: Mapping[str, Any]) -> None:
    """Raise any error unless the values of all cases are of their kinds."""
    for name in GRID:
        for value in grid[name]:
            _require_value(name, value)


def _require_typed(grid: Mapping[str, Any], typed: Mapping[str, Any]) -> None:
    """Raise any error unless there is a text for each value of a field."""
    for name, texts in typed.items():
        if len(texts) != len(grid[name]) or not all(isinstance(text, str) for text in texts):
            raise ValueError(f"typed.{name}: expected a text for each value, got {shown(texts)}")


def _require_value(name: str, value: Any) -> None:
    if name in ("objective", "evaders", "pursuer"):
        described_text(value)
    elif name == "sensing":
        choice(name, value, SENSING)
    elif value is None and name in ("turn_rate", "turn_radius"):
        pass  # the other one is given
    elif not isinstance(value, int | float):
        raise TypeError(f"{name}: expected a number, got {shown(value)}")
    elif name == "team_size" and whole_number(name, value, low=1) > MOST_EVADERS:
        raise ValueError(f"{name}: expected at most {MOST_EVADERS}, got {shown(value)}")


def refuse_differences(folder: Path, before: Mapping[str, Any], now: Mapping[str, Any]) -> None:
    """Raise InputError unless study and versions are those of the folder."""
    differences = [*_differences(before, now, "study"), *_differences(before, now, "versions")]
    if differences:
        lines = [
            f"{folder}: holds another study, and its games can't be mixed with this one's; "
            "choose another folder, or remove this one",
            *differences,
        ]
        raise InputError("\n  ".join(lines))


def _differences(before: Mapping[str, Any], now: Mapping[str, Any], part: str) -> Iterator[str]:
    old, new = dict(flattened(before[part])), dict(flattened(now[part]))
    for key in sorted({*old, *new}):
        if old.get(key) != new.get(key):
            there, here = (
                _text(manifest["typed"].get(key.removeprefix("grid."), values.get(key)))
                for manifest, values in ((before, old), (now, new))
            )
            yield f"{key}: is {there} there, and {here} now"


def _text(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 3] + "..."
