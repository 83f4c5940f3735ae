"""The values that stand in scenario and study files: numbers with a range, angles, points, words.

Each type of value says in words what is wanted, so that every mistake is answered in the same way.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, Literal, Self, TypeVar

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ValidationError,
)
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, core_schema

from covey.kernels.arrays import MOST_IN_GAMES
from covey.model import InputError
from covey.model.validation import LARGEST, LONGEST_UNIT, is_unit_name

WANTED = "wanted"
"""Type of the error of a value; its context gives `words`, what was wanted."""
UNKNOWN_NAME = "unknown_name"
"""Type of the error of a name; its context gives the names `known` too."""


class Section(BaseModel):
    """A table of a file; unknown keys are mistakes."""

    model_config = ConfigDict(extra="forbid", frozen=True)


def wanted(words: str) -> PydanticCustomError:
    """Return the error of a value that isn't what was wanted."""
    # Braces in the message itself would be taken for a place in a template.
    return PydanticCustomError(WANTED, "{words}", {"words": words})


def one_of_words(allowed: Iterable[str]) -> str:
    """Return in words that one of these names is wanted."""
    return "one of " + ", ".join(f'"{name}"' for name in allowed)


@dataclass(frozen=True, eq=False)
class ValueType:
    """A type of value: in words, and a function that reads a value or returns None.

    `written` is what may stand in the file where that is more than the values read. `limits` are
    the words in JSON schema, as far as they can be said there.
    """

    words: str
    read: Callable[[Any], object | None]
    written: Any = None
    limits: Mapping[str, Any] = field(default_factory=dict)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Make pydantic read values of this type with `read` alone."""
        written = handler.generate_schema(self.written or source)
        return core_schema.no_info_plain_validator_function(
            self._check, json_schema_input_schema=written
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Describe the type in words too."""
        return {**handler(schema), **self.limits, "description": self.words}

    def _check(self, value: Any) -> object:
        plain = value.item() if getattr(value, "ndim", None) == 0 else value  # a NumPy number
        result = self.read(plain)
        if result is None:
            raise wanted(_SIZE if _is_too_large(plain) else self.words)
        return result


_SIZE = f"a number of at most {LARGEST:g} in size"


def _is_too_large(value: object) -> bool:
    return isinstance(value, int | float) and LARGEST < abs(value) < math.inf


def is_single(value: object) -> bool:
    """Tell a single value from a list of values."""
    return isinstance(value, str | Mapping) or not isinstance(value, Iterable)


def _as_several(value: Any) -> tuple[Any, ...]:
    values = (value,) if is_single(value) else tuple(value)
    if not values:
        raise wanted("a value or a list of values")
    return values


def _require_different(values: tuple[Any, ...]) -> tuple[Any, ...]:
    twice = [index for index, value in enumerate(values) if value in values[:index]]
    if twice:
        error = {"error": InputError("given twice")}
        details = [
            InitErrorDetails(type="value_error", loc=(index,), input=values[index], ctx=error)
            for index in twice
        ]
        raise ValidationError.from_exception_data("list", details)
    return values


class _SingleToo:
    """Lets the JSON schema of a list accept one value instead."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        several = handler(schema)
        words = several["items"].get("description", "a value")
        return {
            "anyOf": [several["items"], {**several, "minItems": 1, "uniqueItems": True}],
            "description": f"{words}; or a list of different ones",
        }


_Value = TypeVar("_Value")

OneOrMany = Annotated[
    tuple[_Value, ...],
    BeforeValidator(_as_several),
    AfterValidator(_require_different),
    _SingleToo(),
]
"""One value, or a list of different ones."""


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


_LONGEST_ANGLE = 60


class Angle(float):
    """Radians that were given as a text, which is shown again in their place."""

    def __new__(cls, radians: float, text: str) -> Self:
        """Make a number that keeps its text."""
        angle = super().__new__(cls, radians)
        angle.text = text
        return angle

    text: str

    def __reduce__(self) -> tuple[type[Angle], tuple[float, str]]:
        """Return what a copy is made of, in another process too."""
        return Angle, (float(self), self.text)

    def __str__(self) -> str:
        """Return the text."""
        return self.text

    def __repr__(self) -> str:
        """Return the text as Python writes it, from which the same angle is read."""
        return repr(self.text)


def as_angle(value: object) -> float | None:
    """Return radians for a number, "90 deg", "pi", "-pi/2" or "3 pi / 4"; None for all else."""
    if isinstance(value, Angle):
        return value
    if not isinstance(value, str):
        return as_number(value)
    radians = _radians(value)
    return None if radians is None else Angle(radians, value)


def _radians(text: str) -> float | None:
    if len(text) > _LONGEST_ANGLE:  # a search for digits in it might take for ever
        return None
    if degrees := _DEGREES.fullmatch(text):
        return math.radians(float(degrees[1]))
    if share := _OF_PI.fullmatch(text):
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
    return size if size is not None and 1 <= size <= MOST_IN_GAMES else None


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


def one_of(*allowed: str) -> ValueType:
    """Return the type of value that is one of these words."""
    return ValueType(
        one_of_words(allowed),
        lambda value: value if value in allowed else None,
        written=Literal[allowed],
    )


_ANGLE = 'radians, or a string such as "90 deg" or "pi/2"'

# The same in JSON schema, which knows no nan.
_NUMBERS = {"type": "number", "minimum": -LARGEST, "maximum": LARGEST}
_ANGLES = [{"type": "string", "pattern": f"^(?:{each.pattern})$"} for each in (_DEGREES, _OF_PI)]
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
        f"a whole number from 1 to {MOST_IN_GAMES}",
        _team_size,
        limits={"minimum": 1, "maximum": MOST_IN_GAMES},
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
