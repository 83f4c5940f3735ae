"""What FILE means on the command line: a scenario, one that comes with covey, or a record."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from covey.scenarios import Scenario
    from covey.simulation import Game


def read_scenario(name: str, seed: int | None) -> Scenario:
    """Load a scenario by the path of its file or, for one that comes with covey, by its name."""
    from covey.model import InputError
    from covey.scenarios import example_names, example_path, load_scenario
    from covey.simulation.storage import is_parquet

    path = path_of(name, "scenario", {each: example_path(each) for each in example_names()})
    if is_parquet(path):
        raise InputError(
            f"{path}: expected a scenario in TOML, got a Parquet file; `covey draw` draws the "
            "record of a game"
        )
    return load_scenario(path, seed=seed)


def read_scenario_or_game(name: str, seed: int | None) -> Scenario | Game:
    """Load a scenario, or the record of a game if the file is one."""
    from covey.model import InputError
    from covey.simulation import load_game
    from covey.simulation.storage import is_parquet

    if not is_parquet(name):
        return read_scenario(name, seed)
    if seed is not None:
        raise InputError(f"--seed: {name} is the record of a game, which has been played")
    return load_game(name)


def path_of(name: str, what: str, examples: Mapping[str, Path]) -> Path:
    """Return the file that `name` is the path of, or else the example of that name."""
    from covey.model import InputError

    path = Path(name)
    if path.exists():
        return path
    if name in examples:
        return examples[name]
    close = get_close_matches(path.stem, examples, n=1)
    advice = f'did you mean "{close[0]}"?' if close else f"with covey come {', '.join(examples)}"
    raise InputError(f"{name}: no such file, and no {what} of that name; {advice}")
