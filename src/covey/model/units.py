"""Units of the numbers of a game, as tables and pictures write them."""

from __future__ import annotations

from typing import NamedTuple


class Units(NamedTuple):
    """What stands beside numbers: all four are empty where the team names no unit of length."""

    length: str = ""
    time: str = ""
    speed: str = ""
    turn_rate: str = ""


def units_with(length: str) -> Units:
    """Return the units of a game whose lengths are in this unit, and its times in seconds."""
    return Units(length, "s", f"{length}/s", "rad/s") if length else Units()


def with_unit(number: str, unit: str) -> str:
    """Write a number with its unit, if there is one."""
    return f"{number} {unit}" if unit else number


def titled(name: str, unit: str) -> str:
    """Write the title of a column or an axis with its unit, if there is one."""
    return f"{name} ({unit})" if unit else name


def counted(count: int, singular: str) -> str:
    """Write how many there are of something: 1 start, 2 starts."""
    return f"{count} {singular}{'' if count == 1 else 's'}"
