"""Strategies and objectives by their name in a file, or by a table with name and parameters.

strategy = "committed"
strategy = { name = "committed", margin = 0.05 }
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, dataclass, fields
from typing import Any

from covey.model import ExpectedSurvival, InputError, LastCapture, TotalSurvival
from covey.model.objectives import MEASURES
from covey.players import (
    BestSequence,
    CommittedPursuer,
    ConstantHeading,
    FixedSequence,
    FlyingPursuer,
    HoldCourse,
    IterativeOpenLoop,
    KnownSequence,
    LargestDistance,
    NearestFirst,
    OpenLoop,
    RandomSequence,
    SmallestDanger,
    StraightAway,
    UncommittedPursuer,
)
from covey.scenarios.mistakes import (
    Mistake,
    Place,
    did_you_mean,
    toml_text,
    unknown_key,
    wanted_but_got,
)
from covey.scenarios.values import Wanted, as_not_negative, as_point, as_whole, one_of


@dataclass(frozen=True)
class Entry:
    """A strategy or objective, and the kind of value that each of its parameters is."""

    make: Callable[..., Any]
    parameters: Mapping[str, Wanted]


def _starts(value: object) -> int | None:
    return as_whole(value) or None


def _margin(value: object) -> float | None:
    return math.inf if value == math.inf else as_not_negative(value)


def _sequence(value: object) -> list[int] | None:
    if isinstance(value, list) and all(as_whole(i) is not None for i in value):
        return value
    return None


def _sequences(value: object) -> list[list[int]] | None:
    if isinstance(value, list) and value and all(_sequence(each) for each in value):
        return value
    return None


def _weights(value: object) -> list[float] | None:
    if not isinstance(value, list):
        return None
    weights = [as_not_negative(each) for each in value]
    return None if None in weights else value


def _offset(value: object) -> tuple[float, float] | None:
    point = as_point(value)
    return point if point is not None and math.hypot(*point) <= 1.0 else None


_STARTS = {"starts": Wanted("a whole number >= 1", _starts)}
_RESTARTS = {"restarts": Wanted("a whole number >= 0", as_whole)}
_REPLAN_TIME = {"replan_time": Wanted("a finite number >= 0", as_not_negative)}
_MARGIN = {"margin": Wanted("a number >= 0 (inf is allowed)", _margin)}
_OFFSET = {"offset": Wanted("a point [x, y] at most 1 from the origin", _offset)}
_DRAWS = {
    "sequences": Wanted("a list of sequences of evaders' numbers", _sequences),
    "weights": Wanted("a list of finite numbers >= 0", _weights),
}
_SEQUENCE = {"sequence": Wanted("a list of evaders' numbers", _sequence)}

EVADERS = {
    "open-loop": Entry(OpenLoop, _STARTS),
    "iterative-open-loop": Entry(IterativeOpenLoop, _STARTS | _RESTARTS | _REPLAN_TIME),
    "constant-heading": Entry(ConstantHeading, _STARTS | _RESTARTS | _REPLAN_TIME),
    "straight-away": Entry(StraightAway, _REPLAN_TIME),
    "hold-course": Entry(HoldCourse, {}),
    "known-sequence": Entry(KnownSequence, _SEQUENCE | _REPLAN_TIME),
    "largest-distance": Entry(LargestDistance, _REPLAN_TIME),
    "smallest-danger": Entry(SmallestDanger, _REPLAN_TIME),
}

PURSUERS = {
    "committed": Entry(CommittedPursuer, _MARGIN),
    "flying": Entry(FlyingPursuer, _MARGIN | _OFFSET),
    "patient": Entry(UncommittedPursuer, {}),
    "fixed-sequence": Entry(FixedSequence, _SEQUENCE),
    "best-sequence": Entry(BestSequence, {}),
    "random-sequence": Entry(RandomSequence, _DRAWS),
    "nearest-first": Entry(NearestFirst, {}),
}

OBJECTIVES = {
    "last-capture": Entry(LastCapture, {}),
    "total-survival": Entry(TotalSurvival, {}),
    "expected-survival": Entry(ExpectedSurvival, _DRAWS | {"measure": one_of(*MEASURES)}),
}


def strategy_mistakes(place: Place, value: object, known: Mapping[str, Entry]) -> Iterator[Mistake]:
    """Find all mistakes of a strategy or objective, given by name or by a table with its name."""
    if not isinstance(value, str | dict):
        wanted = "a name, or a table with a name and parameters"
        yield Mistake(place, wanted_but_got(wanted, value))
        return
    name, given = name_and_parameters(value)
    if not isinstance(name, str) or name not in known:
        where = (*place, "name") if isinstance(value, dict) else place
        wanted = "one of " + ", ".join(f'"{each}"' for each in known)
        came = "nothing" if name is None else toml_text(name)
        yield Mistake(where, f"expected {wanted}, got {came}{did_you_mean(name, known)}")
        return
    yield from _parameter_mistakes(place, known[name], given)


def _parameter_mistakes(
    place: Place, entry: Entry, given: Mapping[str, object]
) -> Iterator[Mistake]:
    for key, value in given.items():
        wanted = entry.parameters.get(key)
        if wanted is None:
            yield unknown_key((*place, key), ["name", *entry.parameters])
        elif wanted.read(value) is None:
            yield Mistake((*place, key), wanted_but_got(wanted.words, value))
    for field in fields(entry.make):  # type: ignore[arg-type]
        if field.default is MISSING and field.name not in given:
            wanted = entry.parameters[field.name]
            yield Mistake((*place, field.name), f"missing; expected {wanted.words}")


def name_and_parameters(value: str | dict[str, Any]) -> tuple[object, dict[str, Any]]:
    """Split what stands in the file."""
    if isinstance(value, str):
        return value, {}
    return value.get("name"), {key: each for key, each in value.items() if key != "name"}


def misfits_of_parameters(
    place: Place, value: str | dict[str, Any], known: Mapping[str, Entry]
) -> Iterator[Mistake]:
    """Find what doesn't fit together among parameters that are right by themselves."""
    try:
        make_strategy(value, known)
    except InputError as error:
        yield Mistake(place, str(error))


def make_strategy(value: str | dict[str, Any], known: Mapping[str, Entry]) -> Any:
    """Make the strategy or objective of a file without mistakes."""
    name, given = name_and_parameters(value)
    return known[str(name)].make(**given)
