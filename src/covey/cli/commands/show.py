"""`covey show`: the text of a scenario, study or game that comes with covey."""

from __future__ import annotations

import sys
from typing import Annotated

from cyclopts import Parameter

from covey import instances, scenarios, studies


def show(
    name: Annotated[
        str, Parameter(name="NAME", help="Name of a scenario, a study or a game of the covey set.")
    ],
    /,
) -> None:
    """Print a scenario or study that comes with covey, to be read or copied.

    A game of the covey set is a scenario too; `covey instances` lists the set.

    Try:

        covey show fig3 > mine.toml
    """
    from covey.model.validation import choice  # only now, as it loads NumPy

    files = {
        each: room.example_path(each)
        for room in (scenarios, studies)
        for each in room.example_names()
    }
    if name in instances.instance_names():
        path = instances.instance_path(name)
    else:
        path = files[choice("NAME", name, list(files))]
    sys.stdout.write(path.read_text(encoding="utf-8"))
