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
from covey.scenarios.examples import SCENARIOS
from covey.scenarios.mistakes import Mistake, mistakes_of, require_none
from covey.scenarios.scenario import Scenario
from covey.scenarios.schema import ScenarioFile

_LARGEST_FILE = 1_000_000  # bytes
_MOST_LEVELS = 20


def load_scenario(path: str | os.PathLike[str], *, seed: int | None = None) -> Scenario:
    """Load a scenario from its TOML file, or one that comes with covey.

    Parameters
    ----------
    path
        The file; or the name of a scenario that comes with covey, such as "fig3".
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

    Examples
    --------
    >>> import covey
    >>> scenario = covey.load_scenario("fig3")
    >>> len(scenario.team), scenario.sensing
    (5, 'hidden')
    """
    file = SCENARIOS.find(path)
    if seed is not None:
        whole_number("seed", seed, low=0)
    return build(checked(read_document(file, "a scenario"), file), seed)


def read_document(path: Path, what: str) -> dict[str, Any]:
    """Read a TOML file, or raise InputError; `what` is what the file should have been."""
    try:
        with path.open("rb") as file:
            content = file.read(_LARGEST_FILE + 1)
    except OSError as error:
        raise InputError(f"{path}: can't be read: {error.strerror or error}") from error
    if len(content) > _LARGEST_FILE:
        raise InputError(
            f"{path}: expected {what} of at most {_LARGEST_FILE // 1_000_000} MB, got a larger file"
        )
    try:
        document = tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: expected {what} in TOML, got a binary file") from error
    except RecursionError as error:
        raise _too_deep(path, what) from error
    except ValueError as error:  # also from a number of thousands of digits
        raise InputError(f"{path}: expected {what} in TOML: {error}") from error
    if not _is_shallow(document):
        raise _too_deep(path, what)
    return document


def _is_shallow(document: Any) -> bool:
    """Return whether tables and lists are nested at most `_MOST_LEVELS` deep."""
    level = [document]
    for _ in range(_MOST_LEVELS):
        below = [each.values() if isinstance(each, dict) else each for each in level]
        level = [part for parts in below for part in parts if isinstance(part, dict | list)]
    return not level


def _too_deep(path: Path, what: str) -> InputError:
    return InputError(
        f"{path}: expected {what}, got tables or lists more than {_MOST_LEVELS} levels deep"
    )


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
