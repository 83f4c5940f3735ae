"""How much may come in: a budget that fills up with time."""

from __future__ import annotations


class TokenBucket:
    """Allows a cost of `rate` a second in the mean, and of `most` at once."""

    def __init__(self, rate: float, most: float) -> None:
        self._rate, self._most = rate, most
        self._left, self._last = most, 0.0

    def take(self, now: float, cost: float = 1.0) -> bool:
        """Return whether `cost` is within the budget at `now`, in seconds, and take it off."""
        self._left = min(self._most, self._left + self._rate * (now - self._last))
        self._last = now
        if self._left < cost:
            return False
        self._left -= cost
        return True
