"""Files that come with the package."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Examples(NamedTuple):
    """The TOML files of a folder, by name."""

    folder: Path

    def names(self) -> list[str]:
        """Return the names of the files that come with the package."""
        return sorted(path.stem for path in self.folder.glob("*.toml"))

    def path(self, name: str) -> Path:
        """Return the file of this name that comes with the package."""
        return self.folder / f"{name}.toml"


_SCENARIOS = Examples(Path(__file__).parent / "examples")
example_names, example_path = _SCENARIOS.names, _SCENARIOS.path
