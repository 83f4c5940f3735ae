"""Plans that answer captures against random delays, and teams that fly them in random games.

Run with `python -m soak.answers`; a failure is told with its seed, and ends it.
"""

from __future__ import annotations

import argparse
import itertools
import math
import sys
import time
from collections import Counter

import numpy as np

import covey
from soak import case, contingent, players
from soak.delays import ends
from soak.trial import TOLERANCE, describe

SIZES = (3, 4, 5)
TURN_RATES = (math.pi / 4, math.pi / 2, math.pi, 2.0 * math.pi, math.inf)
SCALES = (0.0, 0.01, 0.1, 0.5)
"""Mean delays, relative to the guaranteed time."""


def main(arguments=None):
    """Check what was asked for; return the exit status."""
    parser = argparse.ArgumentParser(prog="python -m soak.answers", description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--trees", type=int, default=150)
    parser.add_argument("--plays", type=int, default=1000, help="against each tree")
    parser.add_argument("--minutes", type=float, default=15.0, help="of games")
    asked = parser.parse_args(arguments)
    against_delays(asked.seed, asked.trees, asked.plays)
    in_games(asked.seed, 60.0 * asked.minutes)
    return 0


def against_delays(seed, trees, plays):
    """Play against trees for starts of section V; tell how near a play came to the guarantee."""
    nearest, undercut = (math.inf,), 0
    study = covey.Study(starts=trees, seed=seed, team_size=SIZES)
    kinds = itertools.cycle(itertools.product(SIZES, TURN_RATES))
    for k, (size, turn_rate) in zip(range(trees), kinds, strict=False):
        start = study.start(k, size)
        team = covey.Team(start.positions, start.headings, 0.25, turn_rate)
        tree = covey.plan_contingent(team, covey.PursuerDisk())
        least = least_end(tree, np.random.default_rng((seed, k)), plays)
        if least < tree.with_delays.survival_time * (1.0 - TOLERANCE):
            raise SystemExit(f"start {k}, {size} evaders, {turn_rate:g}: {least!r}, {tree}")
        nearest = min(nearest, (least / tree.survival_time, k, size, turn_rate))
        undercut += least < tree.survival_time * (1.0 - TOLERANCE)
    print(f"{trees} trees, {plays} plays with delays against each: none below what is guaranteed")
    ratio, k, size, turn_rate = nearest
    print(f"earliest end over the end without delays: {ratio:.9f}, below 1 in {undercut} trees")
    print(f"(start {k}, {size} evaders, turn rate {turn_rate:g})")


def least_end(tree, generator, plays):
    """The earliest end of random plays, half of them in the plan's critical sequences."""
    n = len(tree.evaders)
    sequences = generator.permuted(np.tile(np.arange(n), (plays, 1)), axis=1)
    critical = generator.integers(len(tree.critical_sequences), size=plays // 2)
    sequences[: plays // 2] = np.array(tree.critical_sequences)[critical]
    scales = tree.survival_time * generator.choice(SCALES, (plays, n))
    return float(ends(tree, sequences, generator.exponential(scales)).min())


def in_games(seed, seconds):
    """Play random games; tell how many there were, and the largest error of each check."""
    began, games, kinds, largest = time.monotonic(), 0, Counter(), {}
    for k in itertools.count(seed):
        if time.monotonic() - began >= seconds:
            break
        each = answering_case(k)
        if each is None:
            continue
        team = {"evaders": each.evaders.strategy, "pursuer": each.pursuer.strategy}
        game = covey.simulate(each.team, each.disk, **team, **each.settings())
        found = contingent.promises(each, game)
        games += 1
        kinds.update((f"{len(each.team)} evaders", each.sensing, each.pursuer.name))
        for name, error in found.items():
            largest[name] = max(error, largest.get(name, 0.0))
        if max(found.values()) > TOLERANCE:
            raise SystemExit(f"{found}\n{describe(each)}")
    print(f"{games} games, to seed {k}")
    for name, count in sorted(kinds.items()):
        print(f"{count:7d}  {name}")
    for name, error in largest.items():
        print(f"{error:.1e}  {name}")


def answering_case(seed):
    """The soak's case of a seed, played by a team that answers captures; None if it is too large.

    All pursuers are equally frequent.
    """
    drawn = case.draw(seed)
    if not 2 <= len(drawn.team) <= players.LARGEST_TREE:
        return None
    generator = np.random.default_rng((seed, 1))
    nominal = case.nominal_time(drawn.team, drawn.disk) or 1.0
    setting = players.Setting(drawn.team, drawn.disk, drawn.sensing, nominal, drawn.update_time)
    evaders, pursuer = players.draw_answering(generator, setting)
    return drawn._replace(evaders=evaders, pursuer=pursuer, time_limit=3.0 * nominal)


if __name__ == "__main__":
    sys.exit(main())
