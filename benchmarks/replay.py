"""Gives pytest-benchmark the times of rounds in which many methods took turns.

pytest-benchmark runs one function many times before it comes to the next. To measure interleaved,
all methods are run first, and what each took then passes on this clock instead of a real one.
"""

from __future__ import annotations


class Replay:
    """A clock that goes on only when it is told to."""

    def __init__(self):
        self._time = 0.0

    def now(self):
        """Return the seconds that have been replayed."""
        return self._time

    def run(self, benchmark, durations):
        """Replay durations, in seconds, as the rounds of a benchmark that reads this clock."""
        waiting = iter(durations)
        benchmark.pedantic(self._pass, setup=lambda: ((next(waiting),), {}), rounds=len(durations))

    def _pass(self, duration):
        self._time += duration


REPLAY = Replay()
