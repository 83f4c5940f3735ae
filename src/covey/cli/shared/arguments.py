"""Arguments that several commands take, described once."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

# What was typed, as text. With `Path` in the type the shell completes the names of files.
FileOrName = str | Path

ScenarioFile = Annotated[
    FileOrName,
    Parameter(name="FILE", help="Scenario, a TOML file; or the name of one that comes with covey."),
]

Seed = Annotated[
    int | None,
    Parameter(
        help="Whole number in place of the file's [game] seed. A team that is placed at random "
        "without a seed of its own is placed by it too."
    ),
]

Json = Annotated[
    bool,
    Parameter(
        name="--json",
        negative="",
        show_default=False,
        help="Print JSON with all digits; angles are radians, null stands for infinity.",
    ),
]
