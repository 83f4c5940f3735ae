"""What FILE means on the command line: a scenario, one that comes with covey, or a record."""

from __future__ import annotations

import covey
from covey.cli.shared.arguments import FileOrName


def read_scenario(name: FileOrName, seed: int | None) -> covey.Scenario:
    """Load a scenario by the path of its file or, for one that comes with covey, by its name."""
    from covey.simulation.storage import is_parquet  # only now, as it loads NumPy

    if is_parquet(name):
        raise covey.InputError(
            f"{name}: expected a scenario in TOML, got a Parquet file; `covey draw` draws the "
            "record of a game"
        )
    return covey.load_scenario(name, seed=seed)


def read_scenario_or_game(name: FileOrName, seed: int | None) -> covey.Scenario | covey.Game:
    """Load a scenario, or the record of a game if the file is one."""
    from covey.simulation.storage import is_parquet  # only now, as it loads NumPy

    if not is_parquet(name):
        return read_scenario(name, seed)
    if seed is not None:
        raise covey.InputError(f"--seed: {name} is the record of a game, which has been played")
    return covey.load_game(name)
