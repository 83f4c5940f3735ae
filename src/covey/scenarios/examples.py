"""Scenario files that come with the package."""

from __future__ import annotations

from pathlib import Path

_FOLDER = Path(__file__).parent / "examples"


def example_names() -> list[str]:
    """Return the names of the scenarios that come with the package."""
    return sorted(path.stem for path in _FOLDER.glob("*.toml"))


def example_path(name: str) -> Path:
    """Return the file of the scenario of this name."""
    return _FOLDER / f"{name}.toml"
