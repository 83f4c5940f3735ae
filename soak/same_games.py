"""Whether two games are the same game."""

from __future__ import annotations

import dataclasses

import numpy as np

NOT_COMPARED = {"team", "disk", "strategies"}


def differences(one, other):
    """Names of what differs, to the last bit, between the records of two games."""
    names = [field.name for field in dataclasses.fields(one) if field.name not in NOT_COMPARED]
    return [name for name in names if not np.array_equal(getattr(one, name), getattr(other, name))]
