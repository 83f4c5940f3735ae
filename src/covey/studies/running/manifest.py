"""The manifest of a results folder: the study, the versions of the code, the machine."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from covey.model import InputError
from covey.simulation.storage import whole_file
from covey.studies.design.study import Study, flattened
from covey.studies.running.chunks import chunks_of, starts_per_chunk
from covey.studies.running.provenance import machine, versions

FORMAT = 1
NAME = "manifest.json"
_LONGEST_VALUE = 100


def manifest_of(study: Study) -> dict[str, Any]:
    """Return the manifest of a study that is played by this code on this machine."""
    manifest = {
        "format": FORMAT,
        "study": study.describe(),
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


def write_manifest(folder: Path, manifest: Mapping[str, Any]) -> None:
    """Write the manifest, whole or not at all."""
    with whole_file(folder / NAME) as file:
        file.write((json.dumps(manifest, indent=2, ensure_ascii=False) + "\n").encode())


def read_manifest(folder: Path) -> dict[str, Any] | None:
    """Return the manifest of a folder, or None if the folder has none."""
    path = folder / NAME
    try:
        manifest: dict[str, Any] = json.loads(path.read_bytes())
    except FileNotFoundError:
        return None
    except OSError as error:
        raise InputError(f"{path}: can't be read: {error.strerror}") from error
    except ValueError as error:
        raise InputError(f"{path}: expected the manifest of a study, got {error}") from error
    if manifest.get("format") != FORMAT:
        raise InputError(
            f"{path}: expected the manifest of a study in format {FORMAT}, "
            f"got format {manifest.get('format')}"
        )
    return manifest


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
            yield f"{key}: is {_text(old.get(key))} there, and {_text(new.get(key))} now"


def _text(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 3] + "..."
