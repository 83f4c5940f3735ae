"""Values that hold arrays: equal if all their numbers are, and hashed accordingly."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, fields
from typing import Any

import numpy as np


@dataclass(frozen=True, eq=False)
class Value:
    """A frozen dataclass that compares by its fields: arrays, tuples that hold arrays, others.

    A subclass is declared with `eq=False`: the comparison that dataclasses make can't compare
    arrays.
    """

    def __eq__(self, other: object) -> bool:
        """Return whether this is a value of the same class, with equal fields."""
        if type(other) is not type(self):
            return NotImplemented
        return all(map(_equal, self._all(), other._all()))

    def __hash__(self) -> int:
        """Return a number that is the same for equal values; TypeError if a field has none."""
        return hash((type(self), *map(_hashable, self._all())))

    def _all(self) -> list[Any]:
        return [getattr(self, field.name) for field in fields(self)]


def _equal(one: Any, other: Any) -> bool:
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(_equal, one, other))
    return bool(one == other)


def _hashable(value: Any) -> Hashable:
    if isinstance(value, np.ndarray):  # as numbers, not as bytes: 0.0 and -0.0 are equal
        return (value.shape, *value.ravel().tolist())
    return tuple(map(_hashable, value)) if isinstance(value, tuple) else value
