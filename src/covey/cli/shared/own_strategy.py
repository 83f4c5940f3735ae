"""A strategy of one's own, named on the command line as module:name."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import covey


def load_strategy(text: str) -> Any:
    """Return the team's strategy that `text` names; of a class, what it makes without arguments.

    Raises
    ------
    InputError
        If there is none, or what `check_strategy` finds wrong with it.
    """
    module, _, name = text.partition(":")
    if not module or not name:
        raise covey.InputError(f"expected module:name, such as my_module:MyTeam, got {text}")
    found: Any = _named(_imported(module), name, text)
    if isinstance(found, type):
        try:
            found = found()
        except Exception as error:
            raise covey.InputError(
                f"{text}: {name}() failed: {_told(error)}; expected a class that needs no "
                "arguments, a value or a function"
            ) from error
    from covey.testing import check_strategy  # only now, as it loads the kernels

    try:
        check_strategy(evaders=found)
    except covey.InputError as error:
        raise covey.InputError(f"{text}: {error}") from error
    return found


def _imported(module: str) -> object:
    """Import a module of the working folder, or an installed one."""
    folder = str(Path.cwd())
    if folder not in sys.path:  # an installed `covey` doesn't look there
        sys.path.insert(0, folder)
    try:
        return import_module(module)
    except Exception as error:
        raise covey.InputError(f"{module}: can't be imported: {_told(error)}") from error


def _named(module: object, name: str, text: str) -> object:
    if not hasattr(module, name):
        from covey.scenarios.mistakes import did_you_mean  # only now, as it loads pydantic

        raise covey.InputError(
            f"{text}: the module has no {name}{did_you_mean(name, vars(module))}"
        )
    return getattr(module, name)


def _told(error: Exception) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
