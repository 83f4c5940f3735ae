"""A limit on how much may come in per second."""

from __future__ import annotations


class TokenBucket:
    """Allows `rate` tokens a second on average, and `capacity` at once."""

    def __init__(self, rate: float, capacity: float) -> None:
        self._rate, self._capacity = rate, capacity
        self._tokens, self._last = capacity, 0.0

    def take(self, now: float, cost: float = 1.0) -> bool:
        """Take `cost` tokens at `now`, seconds; return False, and take none, if there are fewer."""
        self._tokens = min(self._capacity, self._tokens + self._rate * (now - self._last))
        self._last = now
        if self._tokens < cost:
            return False
        self._tokens -= cost
        return True
