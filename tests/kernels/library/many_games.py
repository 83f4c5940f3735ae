"""A thousand games of every kind, told to the last bit: the program prints a line for each.

How kernels are compiled must not change a bit of it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))  # where the helpers of the tests are

import covey
from covey.envs.vector import PursuerVectorEnv, TeamVectorEnv
from random_games import random_game

GAMES = 1000
PURSUERS = (
    covey.CommittedPursuer(),
    covey.BestSequence(),
    covey.FixedSequence(),
    covey.UncommittedPursuer(),
    covey.FlyingPursuer(),
)


def lines():
    """Yield a line for each game: what was planned and what happened, in hexadecimal floats."""
    for k in range(GAMES):
        yield " ".join([str(k), *(float(number).hex() for number in game(k))])
    for environment in (PursuerVectorEnv(8), TeamVectorEnv(8)):
        observed, _ = environment.reset(seed=0)
        for _ in range(30):
            observed = environment.step(np.full(environment.action_space.shape, 0.7))[0]
        yield observed.tobytes().hex()


def game(k):
    """Plan and play game number k, and return the numbers that came of it."""
    generator = np.random.default_rng(k)
    team, disk = random_game(
        generator,
        1 + k % 6,
        radius=0.1 * (k % 4 == 1),
        capture_radius=0.02 * (k % 4 == 2),
        mixed=k % 3 == 0,
    )
    if k % 10 == 9:
        first = team.take(np.arange(min(len(team), 3)))
        worst = covey.worst_case(first, disk, update_time=0.5)
        return worst.survival_time, *worst.capture_times
    found = covey.simulate(
        team,
        disk,
        evaders=covey.IterativeOpenLoop(starts=2, restarts=1) if k % 5 else covey.OpenLoop(),
        pursuer=PURSUERS[k % 7 % 5],
        sensing=("hidden", "visible")[k // 3 % 2],
        update_time=0.2,
        seed=k,
        time_limit=10.0,
        objective=objective(k, generator, len(team)),
    )
    return found.guarantee, found.planned_value, *found.capture_times, *found.evader_turns.ravel()


def objective(k, generator, count):
    """Return the objective of game number k, in turn."""
    if k % 4 == 3:
        drawn = {tuple(generator.permutation(count).tolist()) for _ in range(3)}
        return covey.ExpectedSurvival(sorted(drawn))
    return covey.TotalSurvival() if k % 4 == 0 else covey.LastCapture()


if __name__ == "__main__":
    print("\n".join(lines()))
