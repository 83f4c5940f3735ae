"""The figures of a run: kept while it runs, written as JSON, told in a few lines."""

from __future__ import annotations

import json
import os
import platform
import time
from importlib.metadata import version

from soak.case import SHARES
from soak.totals import Totals
from soak.trial import TOLERANCE

SAMPLES = 200
"""Points in time of the memory that are kept, at most; when there are more, every other goes."""


class Summary:
    """What is known of a run.

    Parameters
    ----------
    first, workers
        First seed and number of processes.
    """

    def __init__(self, first, workers):
        self.first, self.workers = first, workers
        self.totals, self.failure, self.memory = Totals(), None, []
        self._begin, self._cpu, self._megabytes = time.monotonic(), {}, {}
        self._every = 0.0  # seconds between two samples of the memory

    def add(self, report):
        """Add what a worker has reported."""
        self.totals.join(report.totals)
        if report.failure is not None:
            self.failure = self.failure or report.failure
            return
        self._cpu[report.worker] = report.cpu_seconds
        self._megabytes[report.worker] = report.megabytes
        now = self.seconds()
        if not self.memory or now - self.memory[-1][0] >= self._every:
            largest = max(self._megabytes.values())
            self.memory.append((round(now, 1), self.totals.games, round(largest, 1)))
        if len(self.memory) > SAMPLES:
            self.memory = self.memory[::2]
            self._every = 2.0 * now / SAMPLES

    def seconds(self):
        """Return the time since the run began."""
        return time.monotonic() - self._begin

    def as_json(self):
        """Return all figures."""
        totals, seconds, cpu = self.totals, self.seconds(), sum(self._cpu.values())
        return {
            "failure": self.failure and {"seed": self.failure[0], "message": self.failure[1]},
            "first_seed": self.first,
            "workers": self.workers,
            "games": totals.games,
            "rows": totals.rows,
            "stopped_at_the_time_limit": totals.stopped,
            "seconds": seconds,
            "cpu_seconds": cpu,
            "games_per_second": totals.games / seconds,
            "games_per_cpu_second": totals.games / cpu if cpu else 0.0,
            "tolerance": TOLERANCE,
            "checks": {
                name: {"times": times, "largest_error": error, "seed": seed}
                for name, (times, error, seed) in sorted(totals.checks.items())
            },
            "parts": {
                name: {"times": totals.times[name], "seconds": spent}
                for name, spent in totals.seconds.most_common()
            },
            "kinds": dict(sorted(totals.kinds.items())),
            "shares": SHARES,
            "memory": {"columns": ["second", "games", "MB of the largest worker"]}
            | {"rows": self.memory},
            "covey": version("covey"),
            "machine": f"{platform.machine()}, {os.cpu_count()} cores, {platform.platform()}",
        }

    def save(self, path):
        """Write all figures, whole or not at all."""
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_suffix(".part")
        part.write_text(json.dumps(self.as_json(), indent=1) + "\n", encoding="utf-8")
        part.replace(path)

    def line(self):
        """Return how far the run is."""
        games, memory = self.totals.games, self.memory[-1][2] if self.memory else 0.0
        return (
            f"{games} games, {games / self.seconds():.0f}/s, worst shortfall "
            f"{self.worst_shortfall():.1e}, {memory:.0f} MB"
        )

    def worst_shortfall(self):
        """Return by how much a survival time was below its promise, relative; 0 if never."""
        return self.totals.checks.get("guarantee is kept", (0, 0.0, 0))[1]

    def text(self):
        """Return the figures that a person reads first."""
        told = self.as_json()
        spent = sum(self.totals.seconds.values())
        lines = [
            f"{told['games']} games from seed {self.first}, {told['rows']} rows, in "
            f"{told['seconds'] / 3600:.2f} h on {self.workers} processes",
            f"{told['games_per_second']:.0f} games a second, "
            f"{told['games_per_cpu_second']:.0f} a second of a core; of its time:",
        ]
        for name, part in told["parts"].items():
            lines.append(f"  {part['seconds'] / spent:4.0%}  {name} ({part['times']} times)")
        shares = ", ".join(f"{name} {share:.0%}" for name, share in SHARES.items())
        lines.append(f"drawn for a share of the games: {shares}")
        lines.append(f"largest errors, of {TOLERANCE:g} allowed:")
        for name, check in told["checks"].items():
            error, seed = check["largest_error"], check["seed"]
            lines.append(f"  {error:.1e}  {name} ({check['times']} times; seed {seed})")
        if self.memory:
            first, last = self.memory[len(self.memory) // 10][2], self.memory[-1][2]
            lines.append(f"memory of a worker: {first:.0f} MB after a tenth, {last:.0f} at the end")
        if self.failure is not None:
            seed, message = self.failure
            lines += ["", message, "", f"stopped; to repeat it: make soak SEED={seed}"]
        return "\n".join(lines)
