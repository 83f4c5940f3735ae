"""When a request is let in: an address that makes many waits, and the others go first."""

from __future__ import annotations


class Admission:
    """Lets `rate` requests of an address in per second, and `burst` at once."""

    def __init__(self, rate: float, burst: int) -> None:
        self._interval = 1.0 / rate
        self._ahead = (burst - 1) / rate
        self._next: dict[str, float] = {}
        """By address: when its next request would be let in, were none ever let in early."""

    def wait(self, address: str, now: float) -> float:
        """Return in how many seconds a request that came at `now` is let in."""
        due = max(now, self._next.get(address, now))
        self._next[address] = due + self._interval
        self._next = {each: when for each, when in self._next.items() if when > now}
        return max(0.0, due - self._ahead - now)
