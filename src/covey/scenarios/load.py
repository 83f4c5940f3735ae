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
from covey.scenarios.consistency import inconsistencies
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
        Replaces the seed in [game], and with it that of a [team.random] without a seed.

    Returns
    -------
    Scenario
        What the file says, with defaults for what it doesn't.

    Raises
    ------
    InputError
        If the file can't be read, or with all of its mistakes, one a line: where, what was
        wanted, what came.

    Notes
    -----
    A team of one, with every other value left to its default, is

    .. code-block:: toml

        [[team.evaders]]
        position = [0.3, 0.1]
    """
    file = Path(path)
    if seed is not None:
        whole_number("seed", seed, low=0)
    return build(checked(read_document(file, "a scenario"), file), seed)


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
    file, mistakes = ScenarioFile(), list[Mistake]()
    try:
        file = ScenarioFile.model_validate(document)
    except ValidationError as error:
        mistakes = list(mistakes_of(error, ScenarioFile, document))
    inconsistent = list(inconsistencies(document))
    # Where a check found the key, the error of the whole table says the same again.
    tables = {each.path[:end] for each in inconsistent for end in range(len(each.path))}
    mistakes = [each for each in mistakes if each.path not in tables]
    require_none([*mistakes, *inconsistent], path)
    return file
