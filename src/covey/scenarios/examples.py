"""Files that come with the package."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

from covey.model.validation import InputError


class Examples(NamedTuple):
    """The TOML files of a folder, by name."""

    folder: Path
    what: str  # they are

    def names(self) -> list[str]:
        """Return the names of the files that come with the package."""
        return sorted(path.stem for path in self.folder.glob("*.toml"))

    def path(self, name: str) -> Path:
        """Return the file of this name that comes with the package."""
        return self.folder / f"{name}.toml"

    def find(self, name: str | os.PathLike[str]) -> Path:
        """Return the file at the path `name` or, where there is none, the one of that name.

        Raises
        ------
        InputError
            If there is neither.
        """
        path, names = Path(name), self.names()
        if path.exists():
            return path
        if str(path) in names:
            return self.path(str(path))
        from covey.scenarios.mistakes import did_you_mean  # only now, as it loads pydantic

        raise InputError(
            f"{path}: no such file, and no {self.what} of that name; "
            f"with covey come {', '.join(names)}{did_you_mean(path.stem, names)}"
        )


TEMPLATE = Path(__file__).parent / "template.toml"
"""A scenario to start from, in which every key is explained."""

SCENARIOS = Examples(Path(__file__).parent / "examples", "scenario")
example_names, example_path = SCENARIOS.names, SCENARIOS.path
