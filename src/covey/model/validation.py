"""Checks of arguments: each function returns the checked value or raises InputError.

Every message names the argument, what was expected and what was given.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from covey.model.units import counted

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


_MOST_SHOWN = 80
LONGEST_UNIT = 12
LARGEST = 1e50
"""Largest length, speed, rate or time. Products of a few of them must be finite."""
SMALLEST_SPEED = 1.0 / LARGEST
"""Of a pursuer: a length over it must be finite."""
MOST_STARTS = 100_000
"""Of a search. Their random numbers take 64 bytes a start and evader."""
_LEAD = 1e-12
"""Least difference of the speeds of a pursuer and an evader, relative."""


def is_slower(speed: float, pursuer_speed: float) -> bool:
    """Tell whether an evader is slower, by a trillionth at least.

    Speeds that are equal up to rounding leave capture times without a correct digit.
    """
    return speed < (1.0 - _LEAD) * pursuer_speed


class InputError(ValueError):
    """An argument that can't be used; the message says what was expected and what was given.

    Examples
    --------
    >>> import covey
    >>> covey.PursuerDisk(speed=-1.0)
    Traceback (most recent call last):
    ...
    covey.model.validation.InputError: speed: expected a finite number > 0, got -1.0
    """


def require_kind(name: str, value: object, kind: type) -> None:
    """Raise InputError unless a value is of a kind."""
    if not isinstance(value, kind):
        raise InputError(f"{name}: expected a {kind.__name__}, got {shown(value)}")


def shown(value: object) -> str:
    """Return a value as a message shows it: shortened."""
    try:
        text = repr(value)
    except ValueError:  # a whole number of thousands of digits
        text = "a number of thousands of digits"
    return text if len(text) <= _MOST_SHOWN else f"{text[:_MOST_SHOWN]}…"


def read_only(array: Floats) -> Floats:
    """Make `array` itself read-only and return it."""
    array.flags.writeable = False
    return array


def frozen_array(
    name: str, value: object, shape: tuple[int | None, ...], largest: float = LARGEST
) -> Floats:
    """Copy `value` to a read-only array of floats of `shape` (None: any length)."""
    return read_only(checked_array(name, value, shape, largest))


def checked_array(
    name: str, value: object, shape: tuple[int | None, ...], largest: float = LARGEST
) -> Floats:
    """Copy `value` to an array of floats of `shape` (None: any length), up to `largest` in size."""
    array = _numbers(name, value)
    if array.shape != shape and not _fits(array.shape, shape):
        wanted = ", ".join("N" if n is None else str(n) for n in shape)
        wanted += "," if len(shape) == 1 else ""
        raise InputError(f"{name}: expected an array of shape ({wanted}), got shape {array.shape}")
    good = np.abs(array) <= largest
    if not good.all():
        _reject(name, array, ~good, f"finite numbers up to {largest:g} in size")
    return array


def _fits(shape: tuple[int, ...], wanted: tuple[int | None, ...]) -> bool:
    return len(shape) == len(wanted) and all(
        n in (None, m) for n, m in zip(wanted, shape, strict=True)
    )


def one_each(name: str, value: object, count: int) -> Floats:
    """Broadcast a scalar or (count,) array of numbers to a new (count,) array."""
    array = _numbers(name, value)
    if array.shape not in {(), (1,), (count,)}:
        raise InputError(
            f"{name}: expected one number, or one for each of {counted(count, 'evader')}, "
            f"got shape {array.shape}"
        )
    return np.broadcast_to(array, (count,)).copy()


def frozen_rates(name: str, value: object, count: int, *, infinite: bool) -> Floats:
    """Broadcast a scalar or (count,) array of rates >= 0 to a read-only (count,) array."""
    array = one_each(name, value, count)
    too_large = (array > LARGEST) & ~(np.isinf(array) & infinite)
    bad = np.isnan(array) | (array < 0) | too_large
    _reject(name, array, bad, "numbers >= 0" + (" (inf is allowed)" if infinite else ", finite"))
    return read_only(array)


def number(
    name: str, value: object, *, low: float = -np.inf, strictly: bool = False, high: float = np.inf
) -> float:
    """Return `value` as a finite float in [low, high], or in (low, high] if `strictly`."""
    array = _numbers(name, value)
    if array.shape != ():
        raise InputError(f"{name}: expected one number, got shape {array.shape}")
    result = float(array)
    inside = low < result <= high if strictly else low <= result <= high
    if not (abs(result) <= LARGEST and inside):
        wanted = "a finite number"
        if low > -np.inf:
            wanted += f" {'>' if strictly else '>='} {low:g}"
        if high < np.inf or LARGEST < abs(result) < np.inf:
            wanted += f"{' and' if low > -np.inf else ''} <= {min(high, LARGEST):g}"
        raise InputError(f"{name}: expected {wanted}, got {shown(value)}")
    return result


def whole_number(name: str, value: object, *, low: int, high: int | None = None) -> int:
    """Return `value` as an int >= `low` and, if `high` is given, <= `high`."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < low:
        raise InputError(f"{name}: expected a whole number >= {low}, got {shown(value)}")
    if high is not None and value > high:
        raise InputError(f"{name}: expected a whole number <= {high}, got {shown(value)}")
    return int(value)


def is_unit_name(value: object) -> bool:
    """Tell whether a value can name a unit: a short word, or no word at all."""
    return isinstance(value, str) and (
        value == "" or (len(value) <= LONGEST_UNIT and value.isprintable() and " " not in value)
    )


def unit_name(name: str, value: object) -> str:
    """Return `value` if it can name a unit."""
    if not is_unit_name(value):
        raise InputError(f'{name}: expected a short word such as "m", got {shown(value)}')
    return str(value)


def choice(name: str, value: object, allowed: Sequence[str]) -> str:
    """Return `value` if it is one of `allowed`."""
    if not isinstance(value, str) or value not in allowed:
        raise InputError(f"{name}: expected one of {', '.join(allowed)}, got {shown(value)}")
    return value


def listed(name: str, value: object) -> list[Any]:
    """Return the items of `value` as a list."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise InputError(f"{name}: expected a list, got {shown(value)}")
    return list(value)


def permutation(name: str, value: object, count: int) -> Ints:
    """Return `value` as a (count,) array that holds each of 0..count-1 once."""
    try:
        array = np.asarray(value)
        fits = array.shape == (count,) and sorted(array.tolist()) == list(range(count))
    except (TypeError, ValueError):  # a ragged list, or items of several types
        fits = False
    if not fits:
        given = value.tolist() if isinstance(value, np.ndarray) else value
        raise InputError(f"{name}: expected each evader 0..{count - 1} once, got {shown(given)}")
    return np.ascontiguousarray(array, dtype=np.int64)


def checked_sequence(name: str, sequence: Sequence[int]) -> tuple[int, ...]:
    """Return a sequence that holds each of 0..N-1 once; else raise InputError."""
    order = listed(name, sequence)
    if not order:
        raise InputError(f"{name}: expected each evader once, got nobody")
    return tuple(permutation(name, order, len(order)).tolist())


def require_whole_team(name: str, sequence: tuple[int, ...], count: int) -> None:
    """Raise InputError unless the sequence is one of `count` evaders."""
    if len(sequence) != count:
        raise InputError(
            f"{name}: expected a sequence of all {counted(count, 'evader')}, "
            f"got {shown(list(sequence))}"
        )


def _numbers(name: str, value: object) -> Floats:
    try:
        array: npt.NDArray[Any] = np.array(value)
        if array.dtype.kind in "biuf":
            return array.astype(np.float64, copy=False)
    except ValueError:
        pass  # a ragged list
    raise InputError(f"{name}: expected numbers, got {shown(value)}")


def _reject(name: str, array: Floats, bad: npt.NDArray[np.bool_], wanted: str) -> None:
    if bad.any():
        first = np.unravel_index(int(np.argmax(bad)), array.shape)
        index = "" if array.size == 1 else "[" + ", ".join(str(int(i)) for i in first) + "]"
        raise InputError(f"{name}: expected {wanted}, got {name}{index} = {array[first]}")
