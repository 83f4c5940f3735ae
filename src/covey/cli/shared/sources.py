"""What FILE means on the command line: a scenario, one that comes with covey, or a record."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path

import covey
from covey import scenarios


def read_scenario(name: str, seed: int | None) -> covey.Scenario:
    """Load a scenario by the path of its file or, for one that comes with covey, by its name."""
    from covey.simulation.storage import is_parquet  # only now, as it loads NumPy

    examples = {each: scenarios.example_path(each) for each in scenarios.example_names()}
    path = path_of(name, "scenario", examples)
    if is_parquet(path):
        raise covey.InputError(
            f"{path}: expected a scenario in TOML, got a Parquet file; `covey draw` draws the "
            "record of a game"
        )
    return covey.load_scenario(path, seed=seed)


def read_scenario_or_game(name: str, seed: int | None) -> covey.Scenario | covey.Game:
    """Load a scenario, or the record of a game if the file is one."""
    from covey.simulation.storage import is_parquet  # only now, as it loads NumPy

    if not is_parquet(name):
        return read_scenario(name, seed)
    if seed is not None:
        raise covey.InputError(f"--seed: {name} is the record of a game, which has been played")
    return covey.load_game(name)


def path_of(name: str, what: str, examples: Mapping[str, Path]) -> Path:
    """Return the file with the path `name` or, where there is none, the example of that name."""
    path = Path(name)
    if path.exists():
        return path
    if name in examples:
        return examples[name]
    close = get_close_matches(path.stem, examples, n=1)
    advice = f'did you mean "{close[0]}"?' if close else f"with covey come {', '.join(examples)}"
    raise covey.InputError(f"{name}: no such file, and no {what} of that name; {advice}")
