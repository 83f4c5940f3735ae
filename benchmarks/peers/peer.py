"""What all peers share: the same starts as this planner, and a value checked by the same means."""

from __future__ import annotations

import time

import covey


class Peer:
    """A solver with `solve(team, disk, turns, memory)`: turns of a local maximum, and a memory.

    What it sets up once for a team size isn't counted.
    """

    def cold(self, moment):
        """Return the seconds from straight flight away to a local maximum, and its value."""
        return self._timed(moment.team, moment.disk, moment.away, None)

    def warm(self, moment):
        """Return the seconds of a replan from what is left of the last plan, and its value.

        A peer that can carries its multipliers over from that plan, as this planner does.
        """
        _, memory = self.solve(moment.team, moment.disk, moment.plan.turns, None)
        return self._timed(moment.later_team, moment.later_disk, moment.left, memory)

    def _timed(self, team, disk, turns, memory):
        start = time.perf_counter()
        found, _ = self.solve(team, disk, turns, memory)
        seconds = time.perf_counter() - start
        return seconds, covey.guaranteed_survival(team, disk, found).time
