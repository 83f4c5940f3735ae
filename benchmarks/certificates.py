"""How soon the worst capture sequence of given headings is proven to be the worst.

`python benchmarks/certificates.py` makes the table of the documentation, in twenty minutes. Games
are those of section V of the paper, headings at random, flight straight ahead. All methods use one
core.
"""

from __future__ import annotations

import argparse
import math
import time
from typing import NamedTuple

import numpy as np

import covey
from peers.didp import Certificate, Didp
from tables import markdown

LIMITS = (1.0, 10.0, 60.0)


class Covey:
    """`covey.guaranteed_survival`."""

    name = "covey"

    def certify(self, team, disk, seconds):
        """Return the certificate that so many seconds bring."""
        begun = time.perf_counter()
        found = covey.guaranteed_survival(team, disk, np.zeros(len(team)), time_limit=seconds)
        spent = time.perf_counter() - begun
        return Certificate(spent, found.time, found.upper, found.exact)


METHODS = (Covey(), Didp())


class CertificateRow(NamedTuple):
    """One method at one size; shares of the games in which the minimum was proven in time."""

    size: int
    method: str
    games: int
    median_seconds: float
    within_1_s: float
    within_10_s: float
    within_60_s: float
    mean_gap: float  # at the limit, per cent of the best sequence known; 0 where it is proven
    largest_gap: float


def game_of(size, game):
    """Return evaders uniform in the unit square, headings at random."""
    generator = np.random.default_rng([size, game])
    positions = generator.uniform(-0.5, 0.5, (size, 2))
    return covey.Team(positions, generator.uniform(-math.pi, math.pi, size)), covey.PursuerDisk()


MEASURED: dict[int, list[CertificateRow]] = {}
"""By size."""


def measure(size, games, limit):
    """Return a row for each method, and keep it; raise if two methods contradict each other."""
    found = {method.name: [] for method in METHODS}
    for game in range(games):
        team, disk = game_of(size, game)
        for method in METHODS:
            found[method.name].append(method.certify(team, disk, limit))
        bounds = [each[-1] for each in found.values()]
        lower, upper = max(each.lower for each in bounds), min(each.upper for each in bounds)
        if lower > upper * (1.0 + 1e-9):
            raise AssertionError(
                f"game {game} of {size}: the bounds {bounds} contradict each other"
            )
    MEASURED[size] = [_row(size, name, each, limit) for name, each in found.items()]
    return MEASURED[size]


def _row(size, name, certificates, limit):
    gaps = [100.0 * (1.0 - each.lower / each.upper) for each in certificates]
    gaps = [0.0 if each.exact else gap for each, gap in zip(certificates, gaps, strict=True)]
    shares = [
        np.mean([each.exact and each.seconds <= within for each in certificates])
        if within <= limit
        else math.nan
        for within in LIMITS
    ]
    return CertificateRow(
        size,
        name,
        len(certificates),
        float(np.median([each.seconds for each in certificates])),
        *map(float, shares),
        float(np.mean(gaps)),
        max(gaps),
    )


def warm_up():
    """Load the kernels, or compile them."""
    Covey().certify(*game_of(2, 0), 1.0)


def main():
    """Print the table of all sizes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", type=int, nargs="+", default=[10, 12, 14, 16, 18, 20, 30])
    parser.add_argument("--games", type=int, default=5)
    parser.add_argument("--limit", type=float, default=LIMITS[-1])
    options = parser.parse_args()
    warm_up()
    rows = []
    for size in options.sizes:
        rows += measure(size, options.games, options.limit)
        print(markdown(rows[-len(METHODS) :]), flush=True)
    print(markdown(rows))


if __name__ == "__main__":
    main()
