"""The upper end of a bracket, computed from what is kept of it."""

from __future__ import annotations

from covey.bounds.bracket import UpperBound, upper_bound
from covey.model import PursuerDisk, Team
from covey.model.validation import Floats


def upper_end_from(
    team: Team, disk: PursuerDisk, start: Floats, sequence: tuple[int, ...]
) -> UpperBound:
    """Return the bound for a pursuer that starts there, and may announce this sequence."""
    there = PursuerDisk(start, 0.0, disk.speed, disk.capture_radius)
    return upper_bound(team, there, [sequence])
