"""`covey new`: a scenario to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

import covey
from covey.cli.shared.outputs import check_output, write_text


def new(
    file: Annotated[
        Path, Parameter(name="FILE", help="The file to be written, mine.toml for example.")
    ],
    /,
) -> None:
    """Write a scenario to start from, in which every key is explained.

    The file is a game as it stands: four vehicles, and a pursuer that was last seen some seconds
    ago, in metres and seconds. A file that exists is never overwritten.

    Try:

        covey new mine.toml
        covey plan mine.toml
    """
    from covey.scenarios.examples import TEMPLATE  # only now, as it loads NumPy

    check_output(file, [".toml"], "a scenario")
    if file.exists():
        raise covey.InputError(f"{file}: exists already; choose another name, or remove it")
    write_text(file, TEMPLATE.read_text(encoding="utf-8"))
