"""The values that stand in scenario and study files: numbers with a range, angles, points."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any

from covey.kernels.arrays import MOST_EVADERS
from covey.model.validation import LARGEST, LONGEST_UNIT, is_unit_name
from covey.scenarios.values.angles import ANGLE_PATTERNS, Angle, radians_of
from covey.scenarios.values.value_types import ValueType


def as_number(value: object) -> float | None:
    """Return a TOML integer or float as a float; None for all else, nan included."""
    if isinstance(value, bool) or not isinstance(value, int | float) or value != value:
        return None
    try:
        return float(value)
    except OverflowError:  # TOML sets no limit to an integer
        return None


def as_angle(value: object) -> float | None:
    """Return radians for a number, "90 deg", "pi", "-pi/2" or "3 pi / 4"; None for all else."""
    if isinstance(value, Angle):
        return value
    if not isinstance(value, str):
        return as_number(value)
    radians = radians_of(value)
    return None if radians is None else Angle(radians, value)


AWAY = "away"
"""The heading straight away from the centre of the pursuer's disk."""


def _heading(value: object) -> float | str | None:
    return AWAY if value == AWAY else _within(as_angle(value), -math.inf, math.inf)


def as_point(value: object) -> tuple[float, float] | None:
    """Return (x, y) for a list of two finite numbers, or None."""
    if not isinstance(value, list | tuple) or len(value) != 2:
        return None
    x, y = (_within(as_number(part), -math.inf, math.inf) for part in value)
    return None if x is None or y is None else (x, y)


def _within(value: float | None, low: float, high: float) -> float | None:
    """Return `value` if it is in [low, high] and no larger in size than `LARGEST`."""
    inside = value is not None and abs(value) <= LARGEST and low <= value <= high
    return value if inside else None


def as_positive(value: object) -> float | None:
    """Return a finite number > 0, or None."""
    return _within(as_number(value), math.nextafter(0.0, 1.0), math.inf)


def as_not_negative(value: object) -> float | None:
    """Return a finite number >= 0, or None."""
    return _within(as_number(value), 0.0, math.inf)


def _at_least_zero(value: float | None) -> float | None:
    """Return a number >= 0 or inf, or None."""
    return math.inf if value == math.inf else _within(value, 0.0, math.inf)


def _duration(value: object) -> float | None:
    return math.inf if value == math.inf else as_positive(value)


def as_whole(value: object) -> int | None:
    """Return a whole number >= 0, or None."""
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else None


def _team_size(value: object) -> int | None:
    size = as_whole(value)
    return size if size is not None and 1 <= size <= MOST_EVADERS else None


def as_sequence(value: object) -> list[int] | None:
    """Return a list of whole numbers >= 0, or None."""
    return _list_of(as_whole, value)


def _list_of(read: Callable[[object], object | None], value: object) -> list[Any] | None:
    """Return a list as it stands if `read` accepts each part, or None."""
    if not isinstance(value, list) or any(read(part) is None for part in value):
        return None
    return value


def _sequences(value: object) -> list[list[int]] | None:
    return _list_of(lambda part: as_sequence(part) or None, value) or None


def _offset(value: object) -> tuple[float, float] | None:
    point = as_point(value)
    return point if point is not None and math.hypot(*point) <= 1.0 else None


_ANGLE = 'radians, or a string such as "90 deg" or "pi/2"'

# The same in JSON schema, which knows no nan.
_NUMBERS = {"type": "number", "minimum": -LARGEST, "maximum": LARGEST}
_ANGLES = [{"type": "string", "pattern": pattern} for pattern in ANGLE_PATTERNS]
_AT_LEAST_0, _ABOVE_0 = {"minimum": 0}, {"exclusiveMinimum": 0}
_EVADER = {"type": "integer", "minimum": 0}

Positive = Annotated[
    float, ValueType("a finite number > 0", as_positive, limits={**_NUMBERS, **_ABOVE_0})
]
NotNegative = Annotated[
    float, ValueType("a finite number >= 0", as_not_negative, limits={**_NUMBERS, **_AT_LEAST_0})
]
Margin = Annotated[
    float,
    ValueType(
        "a number >= 0 (inf is allowed)",
        lambda value: _at_least_zero(as_number(value)),
        limits=_AT_LEAST_0,
    ),
]
Duration = Annotated[float, ValueType("a number > 0 (inf: no limit)", _duration, limits=_ABOVE_0)]
Whole = Annotated[int, ValueType("a whole number >= 0", as_whole, limits=_AT_LEAST_0)]
AtLeastOne = Annotated[
    int,
    ValueType("a whole number >= 1", lambda value: as_whole(value) or None, limits={"minimum": 1}),
]
TeamSize = Annotated[
    int,
    ValueType(
        f"a whole number from 1 to {MOST_EVADERS}",
        _team_size,
        limits={"minimum": 1, "maximum": MOST_EVADERS},
    ),
]
Flag = Annotated[
    bool,
    ValueType("true or false", lambda value: value if isinstance(value, bool) else None),
]
FileName = Annotated[
    str,
    ValueType("the name of a file", lambda value: value if isinstance(value, str) else None),
]
UnitName = Annotated[
    str,
    ValueType(
        'a short word such as "m"',
        lambda value: value if is_unit_name(value) else None,
        limits={"maxLength": LONGEST_UNIT, "pattern": r"^\S*$"},
    ),
]
Point = Annotated[
    tuple[float, float],
    ValueType(
        "a point [x, y] of two numbers", as_point, limits={"prefixItems": [_NUMBERS, _NUMBERS]}
    ),
]
Offset = Annotated[
    tuple[float, float], ValueType("a point [x, y] at most 1 from the origin", _offset)
]
Heading = Annotated[
    float | str,
    ValueType(
        f'a heading: {_ANGLE}, or "{AWAY}"',
        _heading,
        limits={"anyOf": [_NUMBERS, {"const": AWAY}, *_ANGLES]},
    ),
]
Rate = Annotated[
    float,
    ValueType(
        f"a turn rate >= 0: {_ANGLE} (inf is allowed)",
        lambda value: _at_least_zero(as_angle(value)),
        written=float | str,
        limits={"anyOf": [{"type": "number", **_AT_LEAST_0}, *_ANGLES]},
    ),
]
Radius = Annotated[
    float,
    ValueType(
        "a turning radius >= 0 (inf: can't turn)",
        lambda value: _at_least_zero(as_number(value)),
        limits=_AT_LEAST_0,
    ),
]
Sequence = Annotated[
    list[int],
    ValueType("a list of evaders' numbers", as_sequence, limits={"items": _EVADER}),
]
Sequences = Annotated[
    list[list[int]],
    ValueType(
        "a list of sequences of evaders' numbers",
        _sequences,
        limits={"items": {"type": "array", "items": _EVADER, "minItems": 1}, "minItems": 1},
    ),
]
Weights = Annotated[
    list[float],
    ValueType(
        "a list of finite numbers >= 0",
        lambda value: _list_of(as_not_negative, value),
        limits={"items": {**_NUMBERS, **_AT_LEAST_0}},
    ),
]
