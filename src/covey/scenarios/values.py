"""The values that stand in a scenario file: numbers with a range, angles, points.

Each kind says in words what it wants, so that every mistake can be answered in the same way.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic_core import CoreSchema, PydanticCustomError, core_schema

WANTED = "wanted"
"""Type of the errors raised here; their message is what was wanted."""


@dataclass(frozen=True)
class Wanted:
    """A kind of value: what it is in words, and a function that reads one or returns None."""

    words: str
    read: Callable[[object], object | None]

    def __get_pydantic_core_schema__(self, _source: Any, _handler: Any) -> CoreSchema:
        """Make pydantic read values of this kind with `read` alone."""
        return core_schema.no_info_plain_validator_function(self._check)

    def _check(self, value: object) -> object:
        result = self.read(value)
        if result is None:
            # Braces would be taken for a place in a template.
            raise PydanticCustomError(WANTED, "{words}", {"words": self.words})
        return result


def as_number(value: object) -> float | None:
    """Return a TOML integer or float as a float; None for all else, nan included."""
    if isinstance(value, bool) or not isinstance(value, int | float) or value != value:
        return None
    try:
        return float(value)
    except OverflowError:  # TOML sets no limit to an integer
        return None


_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_DEGREES = re.compile(rf"\s*({_NUMBER})\s*(?:deg|degrees|°)\s*")
_OF_PI = re.compile(rf"\s*({_NUMBER}|[+-]?)\s*\*?\s*(?:pi|π)\s*(?:/\s*({_NUMBER}))?\s*")


def as_angle(value: object) -> float | None:
    """Return radians for a number, "90 deg", "pi", "-pi/2" or "3 pi / 4"; None for all else."""
    if not isinstance(value, str):
        return as_number(value)
    if degrees := _DEGREES.fullmatch(value):
        return math.radians(float(degrees[1]))
    if share := _OF_PI.fullmatch(value):
        factor = float(share[1] + "1" if share[1] in {"", "+", "-"} else share[1])
        divisor = float(share[2] or 1)
        return factor * math.pi / divisor if divisor else None
    return None


AWAY = "away"
"""The heading straight away from the centre of the pursuer's disk."""


def _heading(value: object) -> float | str | None:
    return AWAY if value == AWAY else _within(as_angle(value), -math.inf, math.inf)


def as_point(value: object) -> tuple[float, float] | None:
    """Return (x, y) for a list of two finite numbers, or None."""
    if not isinstance(value, list) or len(value) != 2:
        return None
    x, y = (_within(as_number(part), -math.inf, math.inf) for part in value)
    return None if x is None or y is None else (x, y)


def _within(value: float | None, low: float, high: float) -> float | None:
    """Return `value` if it is finite and in [low, high]."""
    return value if value is not None and math.isfinite(value) and low <= value <= high else None


def as_positive(value: object) -> float | None:
    """Return a finite number > 0, or None."""
    return _within(as_number(value), math.nextafter(0.0, 1.0), math.inf)


def as_not_negative(value: object) -> float | None:
    """Return a finite number >= 0, or None."""
    return _within(as_number(value), 0.0, math.inf)


def _rate(value: object) -> float | None:
    rate = as_angle(value)
    return rate if rate is not None and rate >= 0.0 else None


def _duration(value: object) -> float | None:
    return math.inf if value == math.inf else as_positive(value)


def as_whole(value: object) -> int | None:
    """Return a whole number >= 0, or None."""
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else None


def one_of(*allowed: str) -> Wanted:
    """Return the kind of value that is one of these words."""
    words = "one of " + ", ".join(f'"{name}"' for name in allowed)
    return Wanted(words, lambda value: value if value in allowed else None)


_ANGLE = 'radians, or a string such as "90 deg" or "pi/2"'

Positive = Annotated[float, Wanted("a finite number > 0", as_positive)]
NotNegative = Annotated[float, Wanted("a finite number >= 0", as_not_negative)]
Duration = Annotated[float, Wanted("a number > 0 (inf: no limit)", _duration)]
Whole = Annotated[int, Wanted("a whole number >= 0", as_whole)]
Point = Annotated[tuple[float, float], Wanted("a point [x, y] of two numbers", as_point)]
Heading = Annotated[float | str, Wanted(f'a heading: {_ANGLE}, or "{AWAY}"', _heading)]
Rate = Annotated[float, Wanted(f"a turn rate >= 0: {_ANGLE} (inf is allowed)", _rate)]
