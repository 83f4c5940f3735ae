"""The kinds of value that a study is made of, in a file and in Python alike."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from covey.kernels.minimum.last_capture import MOST_EVADERS
from covey.scenarios.mistakes import Mistake, Place, wanted_but_got
from covey.scenarios.samplers import HEADINGS, SHAPES, Disk, Formation, Square
from covey.scenarios.strategies import (
    EVADERS,
    OBJECTIVES,
    PURSUERS,
    Entry,
    make_strategy,
    misfits_of_parameters,
    strategy_mistakes,
)
from covey.scenarios.values import (
    Wanted,
    as_angle,
    as_not_negative,
    as_number,
    as_positive,
    as_whole,
    one_of,
)
from covey.simulation.settings import SENSING
from covey.studies.design.as_visible import AsVisible
from covey.studies.design.start_table import FromFile

Read = tuple[Any, list[Mistake]]
"""A value, and the mistakes that were made in giving it."""


class One(NamedTuple):
    """A single plain value."""

    kind: Wanted

    def read(self, place: Place, value: object) -> Read:
        """Return the value, or the mistake."""
        result = self.kind.read(_without_numpy(value))
        if result is None:
            return None, [Mistake(place, wanted_but_got(self.kind.words, value))]
        return result, []


@dataclass(frozen=True)
class Named:
    """A value by its name, by a table with its name and parameters, or the value itself."""

    known: Mapping[str, Entry]

    def read(self, place: Place, value: object) -> Read:
        """Return the value, or all mistakes in its table."""
        if not isinstance(value, str | dict):
            if callable(value) or hasattr(value, "describe") or hasattr(value, "start"):
                return value, []
            return None, list(strategy_mistakes(place, value, self.known))
        mistakes = list(strategy_mistakes(place, value, self.known))
        mistakes = mistakes or list(misfits_of_parameters(place, value, self.known))
        return None if mistakes else make_strategy(value, self.known), mistakes


@dataclass(frozen=True)
class Several:
    """One value or a list of different ones: a dimension of the grid."""

    each: One | Named

    def read(self, place: Place, value: object) -> Read:
        """Return a tuple of values, or all mistakes in them."""
        if isinstance(value, str | Mapping) or not isinstance(value, Iterable):
            result, mistakes = self.each.read(place, value)
            return (result,), mistakes
        values, mistakes = [], []
        for index, part in enumerate(value):
            result, found = self.each.read((*place, index), part)
            mistakes += found
            if not found and result in values:
                mistakes.append(Mistake((*place, index), "given twice"))
            values.append(result)
        if not values:
            mistakes.append(Mistake(place, "expected a value or a list of values, got []"))
        return tuple(values), mistakes


def _without_numpy(value: object) -> object:
    """Numbers of NumPy are taken for what they mean."""
    item: Callable[[], object] | None = getattr(value, "item", None)
    return value if item is None else item()


def _size(value: object) -> int | None:
    size = as_whole(value)
    return size if size is not None and 1 <= size <= MOST_EVADERS else None


def _rate(value: object) -> float | None:
    rate = as_angle(value)
    return rate if rate is not None and rate >= 0.0 else None


def _flag(value: object) -> bool | None:
    return value if isinstance(value, bool) else None


_POSITIVE = Wanted("a finite number > 0", as_positive)
_NOT_NEGATIVE = Wanted("a finite number >= 0", as_not_negative)
_MARGIN = Wanted(
    "a number >= 0 (inf is allowed)",
    lambda value: number if (number := as_number(value)) is not None and number >= 0.0 else None,
)
_RATE = Wanted(
    'a turn rate >= 0: radians, or a string such as "90 deg" or "pi/2" (inf is allowed)', _rate
)
_TEXT = Wanted("the name of a file", lambda value: value if isinstance(value, str) else None)

SAMPLERS = {
    "square": Entry(Square, {"side": _POSITIVE, "headings": one_of(*HEADINGS)}),
    "disk": Entry(Disk, {"radius": _POSITIVE, "headings": one_of(*HEADINGS)}),
    "formation": Entry(
        Formation,
        {"shape": one_of(*SHAPES), "spacing": _POSITIVE, "distance": _NOT_NEGATIVE},
    ),
    "file": Entry(FromFile, {"path": _TEXT}),
}
STUDY_PURSUERS = {**PURSUERS, "as-visible": Entry(AsVisible, {"margin": _MARGIN})}

FIELDS: dict[str, One | Named | Several] = {
    "starts": One(Wanted("a whole number >= 1", lambda value: as_whole(value) or None)),
    "seed": One(Wanted("a whole number >= 0", as_whole)),
    "sampler": Named(SAMPLERS),
    "trajectories": One(Wanted("true or false", _flag)),
    "team_size": Several(One(Wanted(f"a whole number from 1 to {MOST_EVADERS}", _size))),
    "speed": Several(One(_NOT_NEGATIVE)),
    "turn_rate": Several(One(_RATE)),
    "pursuer_speed": Several(One(_POSITIVE)),
    "disk_radius": Several(One(_NOT_NEGATIVE)),
    "capture_radius": Several(One(_NOT_NEGATIVE)),
    "update_time": Several(One(_POSITIVE)),
    "sensing": Several(One(one_of(*SENSING))),
    "objective": Several(Named(OBJECTIVES)),
    "evaders": Several(Named(EVADERS)),
    "pursuer": Several(Named(STUDY_PURSUERS)),
}
"""How each value of a study is read; the names are those of `Study`."""
