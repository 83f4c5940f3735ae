"""What a study is: starts, and the grid of cases in which every one of them is played."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np

from covey.model import LastCapture
from covey.model.display import html_facts
from covey.model.team import DEFAULT_TURN_RATE
from covey.model.validation import InputError
from covey.model.value import Value
from covey.players import CommittedPursuer, IterativeOpenLoop
from covey.scenarios.samplers import Sampler, Square
from covey.simulation.strategy import description
from covey.studies.design.case import GRID, Case, InitialState
from covey.studies.design.start_table import FromFile


@dataclass(frozen=True, eq=False)
class Study(Value):
    """Many games: every start in every case of a grid, so that all comparisons are paired.

    The first five are single values. Each of the others is a value or a sequence of values, and
    every combination is a case.

    Parameters
    ----------
    starts
        How many starts are drawn.
    seed
        From which all of them come. A start depends on it and on its own number alone.
    sampler
        How they are drawn: `Square`, `Disk`, `Formation`, `FromFile`.
    trajectories
        Whether the course of every game is kept too.
    unit
        The unit of all lengths, "m" for example, as in `Team`: tables and pictures of the study
        name the units.
    team_size
        Evaders, 1 to 50.
    speed
        Of every evader. Default: the paper's.
    turn_rate, turn_radius
        Of every evader, one of the two; "pi/2" or "90 deg" will do for a turn rate. With a turning
        radius R the rate is ω = speed/R in each case. Default: the paper's turn rate, π/2.
    pursuer_speed, disk_radius, capture_radius
        The pursuer, in a disk around the origin.
    update_time, sensing
        See `covey.simulate`.
    objective
        What the games are about, by the names that study files know or as values.
    evaders, pursuer
        Strategies, by the names that study files know or as values, your own too.

    Raises
    ------
    InputError
        With all mistakes, one a line.

    Examples
    --------
    >>> import covey
    >>> study = covey.Study(starts=20, team_size=[2, 3], sensing="hidden")
    >>> study.team_size
    (2, 3)
    """

    starts: int = 500
    seed: int = 0
    sampler: Sampler = Square()  # noqa: RUF009 frozen
    trajectories: bool = False
    unit: str = ""
    team_size: Any = 5
    speed: Any = 0.25
    turn_rate: Any = None
    turn_radius: Any = None
    pursuer_speed: Any = 1.0
    disk_radius: Any = 0.0
    capture_radius: Any = 0.0
    update_time: Any = 0.01
    sensing: Any = ("visible", "hidden")
    objective: Any = LastCapture()  # noqa: RUF009 frozen
    evaders: Any = IterativeOpenLoop()  # noqa: RUF009 frozen
    pursuer: Any = CommittedPursuer()  # noqa: RUF009 frozen

    def __post_init__(self) -> None:
        """Check all fields, and make each of the grid a tuple."""
        # Imported here: the study of a worker is checked already, and needs no pydantic.
        from covey.studies.design.fields import ALL_GIVEN, read_fields

        given = {field.name: getattr(self, field.name) for field in fields(self)}
        grid = {name: _kept(given.pop(name)) for name in GRID}
        values, mistakes = read_fields({**given, "grid": grid}, ALL_GIVEN)
        if mistakes:
            lines = [str(mistake).removeprefix("grid.") for mistake in mistakes]
            raise InputError("study: " + "\n  ".join(lines))
        if values["turn_rate"] is None and values["turn_radius"] is None:
            values["turn_rate"] = (DEFAULT_TURN_RATE,)
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def _repr_html_(self) -> str:
        return html_facts(
            "Study", {field.name: getattr(self, field.name) for field in fields(self)}
        )

    @cached_property
    def cases(self) -> tuple[Case, ...]:
        """All combinations of the grid, the last field fastest."""
        return tuple(Case(*values) for values in product(*map(self._values, GRID)))

    @property
    def games(self) -> int:
        """How many games are played; game i is start i // len(cases) in case i % len(cases)."""
        return self.starts * len(self.cases)

    def start(self, number: int, team_size: int) -> InitialState:
        """Draw a start; the same, whatever else is drawn."""
        layout, search = np.random.SeedSequence(self.seed, spawn_key=(number,)).spawn(2)
        generator = np.random.default_rng(layout)
        positions, headings = self.sampler.draw(number, team_size, generator)
        return InitialState(positions, headings, int(search.generate_state(1)[0]))

    def only(self, first: int, last: int) -> Study:
        """Return what a worker needs to play the starts from `first` up to `last`."""
        if isinstance(self.sampler, FromFile):
            return replace(self, sampler=self.sampler.all.only(first, last))
        return self

    def describe(self) -> dict[str, Any]:
        """Return all that the games follow from, as a study file gives it."""
        own = [field.name for field in fields(self) if field.name not in GRID]
        described = {name: plain(getattr(self, name)) for name in own}
        described["grid"] = {name: [plain(v) for v in self._values(name)] for name in GRID}
        return described

    def _values(self, name: str) -> tuple[Any, ...]:
        """Return the values of a field of the grid; None is that of a field that isn't given."""
        given = getattr(self, name)
        return (None,) if given is None else given


def _kept(value: object) -> object:
    """List what an iterator gives: mistakes are looked up in the values a second time.

    [None] is a field that isn't given, as `describe` writes it.
    """
    kept = list(value) if isinstance(value, Iterator) else value
    return None if isinstance(kept, list) and len(kept) == 1 and kept[0] is None else kept


def plain(value: object) -> object:
    """Return a value of a field as a study file gives it."""
    if value is None or isinstance(value, bool | int | float | str | tuple):
        return value
    return dict(description(value))


def flattened(tree: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Return the leaves of nested tables by their paths: ("grid.speed", [0.25])."""
    for key, value in tree.items():
        if isinstance(value, Mapping):
            yield from flattened(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value
