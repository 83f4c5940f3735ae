"""Angles that a file gives as texts, "90 deg" or "pi/2" for example."""

from __future__ import annotations

import math
import re
from typing import Self

_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_DEGREES = re.compile(rf"\s*({_NUMBER})\s*(?:deg|degrees|°)\s*")
_OF_PI = re.compile(rf"\s*({_NUMBER}|[+-]?)\s*\*?\s*(?:pi|π)\s*(?:/\s*({_NUMBER}))?\s*")
_LONGEST_ANGLE = 60

ANGLE_PATTERNS = tuple(f"^(?:{each.pattern})$" for each in (_DEGREES, _OF_PI))
"""Which texts are angles, for JSON schema."""


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


def radians_of(text: str) -> float | None:
    """Return radians for "90 deg", "pi", "-pi/2" or "3 pi / 4"; None for all else."""
    if len(text) > _LONGEST_ANGLE:  # a search for digits in it might take for ever
        return None
    if degrees := _DEGREES.fullmatch(text):
        return math.radians(float(degrees[1]))
    if share := _OF_PI.fullmatch(text):
        factor = float(share[1] + "1" if share[1] in {"", "+", "-"} else share[1])
        divisor = float(share[2] or 1)
        return factor * math.pi / divisor if divisor else None
    return None
