"""What many trials come to: counts, times, and the largest error of each check with its seed."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field


@dataclass
class Totals:
    """Of trials, and then of the totals of several workers.

    Attributes
    ----------
    games, rows, stopped : int
        Games, rows of their records, and games that a time limit ended.
    kinds : Counter
        Games by kind: "evaders: open loop", "sensing: hidden" and so on.
    seconds, times : Counter
        Time in each part of a trial, and how often the part was done.
    checks : dict
        For each check how often it was made, its largest error, and the seed of that.
    """

    games: int = 0
    rows: int = 0
    stopped: int = 0
    kinds: Counter = field(default_factory=Counter)
    seconds: Counter = field(default_factory=Counter)
    times: Counter = field(default_factory=Counter)
    checks: dict = field(default_factory=dict)

    def add(self, trial):
        """Count a trial."""
        case = trial.case
        self.games += 1
        self.rows += trial.rows
        self.stopped += trial.stopped
        self.kinds.update(
            {
                f"evaders: {case.evaders.name}": 1,
                f"pursuer: {case.pursuer.name}": 1,
                f"sensing: {case.sensing}": 1,
                f"objective: {case.objective.describe()['name']}": 1,
                f"size: {len(case.team):2d}": 1,
            }
        )
        self.seconds.update(trial.seconds)
        self.times.update(trial.seconds.keys())
        for check, error in trial.errors.items():
            self._add_check(check, 1, error, case.seed)

    def join(self, other):
        """Add the totals of other games."""
        for name in ("games", "rows", "stopped"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        for name in ("kinds", "seconds", "times"):
            getattr(self, name).update(getattr(other, name))
        for check, (times, error, seed) in other.checks.items():
            self._add_check(check, times, error, seed)

    def _add_check(self, check, times, error, seed):
        before, largest, of = self.checks.get(check, (0, -1.0, -1))
        # Of equal errors the least seed, so that the number of workers changes nothing.
        error, seed = min((largest, of), (error, seed), key=lambda pair: (-pair[0], pair[1]))
        self.checks[check] = (before + times, error, seed)
