"""Where the files of the set are, and their names."""

from __future__ import annotations

from pathlib import Path

_FOLDER = Path(__file__).parent


def instance_names() -> list[str]:
    """Return the names of all games of the set, by family and size.

    Examples
    --------
    >>> import covey
    >>> covey.instances.instance_names()[:2]
    ['agile-5', 'agile-12']
    """
    return sorted((path.stem for path in (_FOLDER / "games").glob("*.toml")), key=_family_and_size)


def instance_path(name: str) -> Path:
    """Return the file with the state of a game: a scenario."""
    return _FOLDER / "games" / f"{name}.toml"


def values_path(name: str) -> Path:
    """Return the file with what is known about a game."""
    return _FOLDER / "values" / f"{name}.toml"


def require_instance(name: object) -> str:
    """Return `name` if a game of the set has it; else raise InputError."""
    names = instance_names()
    if isinstance(name, str) and name in names:
        return name
    # Only now, as both load NumPy.
    from covey.model.validation import InputError, shown
    from covey.scenarios.mistakes import did_you_mean

    raise InputError(
        f"expected the name of a game of the covey set, got {shown(name)}; `covey instances` lists "
        f"all {len(names)}{did_you_mean(name, names)}"
    )


def _family_and_size(name: str) -> tuple[str, int]:
    family, _, size = name.rpartition("-")
    return family, int(size)
