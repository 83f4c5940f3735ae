"""How often the default plan is as good as the best one known: `python benchmarks/quality.py`.

Games as in section V of the paper, with headings at random. The best one known is that of 500
starts, half of them random, half the search's own.
"""

from __future__ import annotations

import math
import time

import numpy as np

import covey
from covey.kernels.maximum.initial_guesses import BEGINNINGS, make_elite
from covey.kernels.maximum.multistart import search_all
from covey.planning.compiled_objective import aim_of
from covey.planning.guarantee import pursuit_of
from covey.planning.multistart import MOST_STEPS
from covey.planning.open_loop import DEFAULT_TOLERANCE, start_noise

GAMES, STARTS = 200, 250


def random_team(size, game):
    """Return evaders uniform in the unit square."""
    generator = np.random.default_rng([size, game])
    return covey.Team(
        generator.uniform(-0.5, 0.5, (size, 2)), generator.uniform(-math.pi, math.pi, size)
    )


def best_known(team, disk):
    """Return the best value of a search that varies what it finds and of one that doesn't."""
    values = [covey.plan(team, disk, starts=STARTS, seed=1).survival_time]
    for seed in range(STARTS // BEGINNINGS):
        noise = start_noise(100 + seed, BEGINNINGS, len(team))
        found = search_all(
            team.as_rows(),
            pursuit_of(disk),
            aim_of(covey.LastCapture(), len(team)),
            noise,
            BEGINNINGS,
            DEFAULT_TOLERANCE,
            MOST_STEPS,
            make_elite(len(team)),
        )
        values.append(found.value)
    return max(values)


def main():
    """Print a line for each size of the team."""
    disk = covey.PursuerDisk()
    print("size  games  within 1e-6  within 1e-3  worst loss  median ms  longest ms")
    for size in (2, 3, 4, 5, 8):
        lost, seconds = [], []
        covey.plan(random_team(size, 0), disk)
        for game in range(GAMES):
            team = random_team(size, game)
            start = time.perf_counter()
            value = covey.plan(team, disk).survival_time
            seconds.append(time.perf_counter() - start)
            lost.append(1.0 - value / max(best_known(team, disk), value))
        close = [np.mean(np.less_equal(lost, bound)) for bound in (1e-6, 1e-3)]
        print(
            f"{size:4}  {GAMES:5}  {close[0]:11.3f}  {close[1]:11.3f}  {max(lost):10.2e}"
            f"  {1e3 * np.median(seconds):9.2f}  {1e3 * max(seconds):10.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
