"""How many updates are due in real time: pace, pause, and a machine that is too slow."""

from __future__ import annotations

from collections import deque

_MOST_OWED = 1.0 / 30.0
"""Seconds that are made up for; beyond them the game falls behind real time."""

_RATE_OVER = 1.0
"""Seconds over which the rate of updates is counted."""


class Pacer:
    """Says how many updates are due.

    An update is always Δt of the game's time. A machine that can't keep up plays fewer updates a
    second, so the game runs slower than the pace that was asked for.

    Parameters
    ----------
    update_time
        Δt of the game.
    """

    def __init__(self, update_time: float) -> None:
        self._update_time = update_time
        self.pace = 1.0
        self.running = False
        self._last = 0.0
        self._owed = 0.0
        self._played: deque[tuple[float, int]] = deque()

    def run(self, now: float) -> None:
        """Let time run from `now`, seconds."""
        if not self.running:
            self.running, self._last, self._owed = True, now, 0.0
            self._played.clear()

    def pause(self) -> None:
        """Let time stand still."""
        self.running = False

    def due(self, now: float) -> int:
        """Return how many updates to play now."""
        if not self.running:
            return 0
        self._owed += self.pace * min(now - self._last, _MOST_OWED)
        self._last = now
        updates = int(self._owed / self._update_time)
        self._owed -= updates * self._update_time
        return updates

    def count(self, now: float, updates: int) -> None:
        """Count `updates` that were played, for `rate`."""
        self._played.append((now, updates))
        while self._played[0][0] < now - _RATE_OVER:
            self._played.popleft()

    def rate(self, now: float) -> float:
        """Return the updates played a second, over the last `_RATE_OVER` seconds."""
        if not self._played:
            return 0.0
        # The updates of the first entry were played before its time.
        since = self._played[0][0]
        played = sum(updates for _, updates in self._played) - self._played[0][1]
        return played / (now - since) if now > since else 0.0
