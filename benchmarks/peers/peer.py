"""What all peers share: the same starts as this planner, and a value checked by the same means."""

from __future__ import annotations

import time

import covey
from moments import Answer

SAME = 1e-6
"""Values that differ by less than this, relative, are the same local maximum."""


class Peer:
    """A solver with `solve(team, disk, turns, memory)`: turns of a local maximum, and a memory.

    What it sets up once for a team size isn't counted.
    """

    def cold(self, moment):
        """Plan from straight flight away."""
        return self._timed(*moment.first, None)

    def warm(self, moment):
        """Replan from what is left of the last plan.

        A peer that can carries its multipliers over from that plan, as this planner does.
        """
        _, memory = self.solve(*moment.before, None)
        return self._timed(*moment.now, memory)

    def _timed(self, team, disk, turns, memory):
        start = time.perf_counter()
        found, _ = self.solve(team, disk, turns, memory)
        seconds = time.perf_counter() - start
        value = covey.guaranteed_survival(team, disk, found).time
        further = covey.plan(team, disk, starts=1, warm_start=found).survival_time
        return Answer(seconds, value, further <= value * (1.0 + SAME))
