"""A bug is one text of a file, and the text that replaces it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Bug(NamedTuple):
    """A text of one file that another text replaces."""

    name: str
    file: str  # below src/covey
    old: str
    new: str
    harm: str  # what the bug does to a user

    @property
    def room(self) -> str:
        """The room that the bug is in."""
        return self.file.split("/")[0]

    def plant(self, package: Path) -> None:
        """Change the file of a package; LookupError unless the old text stands there once."""
        path = package / self.file
        source = path.read_text(encoding="utf-8")
        if source.count(self.old) != 1:
            raise LookupError(f"{self.name}: {self.file} holds the text {source.count(self.old)}x")
        path.write_text(source.replace(self.old, self.new), encoding="utf-8")
