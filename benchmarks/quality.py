"""How often the default plan is as good as the best one known: `python benchmarks/quality.py`.

Games as in section V of the paper, with headings at random. The best one known is that of 500
starts, half of them random, half the search's own.
"""

from __future__ import annotations

import math
import time

import numpy as np

import covey
from covey.kernels.maximum.initial_guesses import N_RANDOM
from covey.kernels.maximum.problem import Problem
from covey.planning.border import pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.multistart import NONE, Search
from covey.planning.open_loop import DEFAULT_TOLERANCE, guess_uniforms

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
    objective = compiled_objective(covey.LastCapture(), len(team))
    problem = Problem(team.as_rows(), pursuit_of(disk), objective)
    for seed in range(STARTS // N_RANDOM):
        uniforms = guess_uniforms(100 + seed, N_RANDOM, len(team))
        search = Search(problem, DEFAULT_TOLERANCE, uniforms, math.inf)
        values.append(search.run(NONE, N_RANDOM).value)
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
