"""From a scenario file to a scenario, or to the list of all its mistakes."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from covey.model import InputError
from covey.model.validation import whole_number
from covey.scenarios.build import build
from covey.scenarios.consistency import crosschecks
from covey.scenarios.mistakes import Mistake, mistakes_of, require_none
from covey.scenarios.scenario import Scenario
from covey.scenarios.schema import ScenarioFile


def load_scenario(path: str | os.PathLike[str], *, seed: int | None = None) -> Scenario:
    """Load a scenario from its TOML file.

    Parameters
    ----------
    path
        The file.
    seed
        Takes the place of the seed in [game], and so of [team.random] where that names none.

    Returns
    -------
    Scenario
        What the file says, with defaults for what it doesn't.

    Raises
    ------
    InputError
        If the file can't be read, or with all of its mistakes, one a line: the place, what was
        wanted, what came.

    Notes
    -----
    A team of one, with every other value left to its default, is

    .. code-block:: toml

        [[team.evaders]]
        position = [0.3, 0.1]
    """
    place = Path(path)
    if seed is not None:
        whole_number("seed", seed, low=0)
    return build(checked(read_document(place, "a scenario"), place), seed)


def read_document(path: Path, what: str) -> dict[str, Any]:
    """Read a TOML file, or raise InputError; `what` is what the file should have been."""
    try:
        return tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise InputError(f"{path}: can't be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: expected {what} in TOML, got a binary file") from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path}: expected {what} in TOML: {error}") from error


def checked(document: dict[str, Any], path: Path) -> ScenarioFile:
    """Check what a file says, or raise InputError with all of its mistakes."""
    mistakes: list[Mistake] = []
    file = ScenarioFile()
    try:
        file = ScenarioFile.model_validate(document)
    except ValidationError as error:
        mistakes += mistakes_of(error)
    require_none([*mistakes, *crosschecks(document)], path)
    return file
