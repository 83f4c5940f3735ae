"""Whose turn it is: of those who wait, the one that has had least."""

from __future__ import annotations

from collections import deque
from typing import Generic, TypeVar

Item = TypeVar("Item")


class FairQueue(Generic[Item]):
    """Start-time fair queueing (Goyal, Vin and Cheng, 1996): many items give a user no more time.

    A user's items are taken in their order. Nobody saves up time by asking for nothing.
    """

    def __init__(self) -> None:
        self._waiting: dict[str, deque[Item]] = {}
        self._had: dict[str, float] = {}
        self._least = 0.0
        """What the user that was taken last had then. Of those who wait, nobody has had less."""

    def put(self, user: str, item: Item) -> None:
        """Let `item` wait for its turn."""
        if user not in self._waiting:
            self._waiting[user] = deque()
            self._had[user] = max(self._had.get(user, 0.0), self._least)
        self._waiting[user].append(item)

    def take(self) -> tuple[str, Item]:
        """Return whose turn it is, and the item."""
        user = min(self._waiting, key=self._had.__getitem__)
        self._least = self._had[user]
        items = self._waiting[user]
        item = items.popleft()
        if not items:
            del self._waiting[user]
        return user, item

    def charge(self, user: str, seconds: float) -> None:
        """Count what an item of `user` took."""
        self._had[user] = self._had.get(user, self._least) + seconds
        for other in [each for each, had in self._had.items() if had <= self._least]:
            if other not in self._waiting:
                del self._had[other]  # `put` would begin at `_least`
