"""`covey show`: the text of a scenario or study that comes with covey."""

from __future__ import annotations

import sys
from typing import Annotated

from cyclopts import Parameter

from covey import scenarios, studies


def show(
    name: Annotated[
        str, Parameter(name="NAME", help="Name of a scenario or study that comes with covey.")
    ],
    /,
) -> None:
    """Print a scenario or study that comes with covey, to be read or copied.

    Try:

        covey show fig3 > mine.toml
    """
    from covey.model.validation import choice  # only now, as it loads NumPy

    files = {
        each: room.example_path(each)
        for room in (scenarios, studies)
        for each in room.example_names()
    }
    sys.stdout.write(files[choice("NAME", name, list(files))].read_text(encoding="utf-8"))
