"""From the two files of a game to the game and what is known about it."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from covey.bounds.bracket import LowerEnd, UpperEndKind
from covey.instances.files import instance_path, require_instance, values_path
from covey.instances.instance import Instance, KnownBracket, KnownPlan
from covey.model import PursuerDisk, Team
from covey.model.validation import frozen_array


def load_instance(name: str) -> Instance:
    """Load a game of the covey set, and what is known about it.

    Parameters
    ----------
    name
        One of `covey.instances.instance_names()`, such as "circle-30".

    Returns
    -------
    Instance
        The state of the game, the best plan known, and the bracket of the true value.

    Raises
    ------
    InputError
        If no game of the set has this name.

    Examples
    --------
    >>> import covey
    >>> game = covey.load_instance("circle-30")
    >>> len(game.team), game.disk.radius
    (30, 0.0)
    """
    team, disk = load_state(name)
    values = _document(values_path(name))
    return Instance(name, team, disk, _plan_in(values["plan"]), _bracket_in(values["bracket"]))


def load_state(name: str) -> tuple[Team, PursuerDisk]:
    """Return the state of a game at time 0, from a scenario that says all for each evader."""
    document = _document(instance_path(require_instance(name)))
    evaders = document["team"]["evaders"]
    positions, headings, speeds, turn_rates = (
        [evader[key] for evader in evaders] for key in ("position", "heading", "speed", "turn_rate")
    )
    unit = document.get("unit", "")
    team = Team(positions, headings, speeds, turn_rates, unit=unit)
    return team, PursuerDisk(**document["pursuer"], unit=unit)


def _document(path: Path) -> dict[str, Any]:
    return tomllib.loads(path.read_text(encoding="utf-8"))


def _plan_in(table: dict[str, Any]) -> KnownPlan:
    n = len(table["turns"])
    return KnownPlan(
        turns=frozen_array("turns", table["turns"], (n,)),
        goal_headings=frozen_array("goal_headings", table["goal_headings"], (n,)),
        survival_time=table["survival_time"],
        worst_sequence=tuple(table["worst_sequence"]),
        upper=table["upper"],
    )


def _bracket_in(table: dict[str, Any]) -> KnownBracket:
    return KnownBracket(
        lower=table["lower"],
        lower_by=LowerEnd(table["lower_by"]),
        depth=table["depth"],
        upper=table["upper"],
        upper_by=UpperEndKind(table["upper_by"]),
        sequence=tuple(table["sequence"]),
        start=frozen_array("start", table["start"], (2,)),
    )
