"""What plans that answer captures gain, what delays cost them, and what they take.

Run with `python benchmarks/answers.py`. Starts are those of section V of the paper. Times are of
the processor, one after the other in one process.
"""

from __future__ import annotations

import argparse
import math
import time

import numpy as np

import covey
from covey.kernels.contingent.scratch import new_branches
from covey.planning.contingent.search import ascend

TURN_RATES = {"π/2": math.pi / 2, "2π": 2.0 * math.pi, "∞": math.inf}


def main():
    """Print a line for each team size, turn rate and depth."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--starts", type=int, default=50)
    parser.add_argument("--sizes", type=int, nargs="+", default=[3, 4, 5])
    parser.add_argument("--depths", type=int, nargs="*", default=[], help="by default all captures")
    options = parser.parse_args()
    print("  N    ω  depth  gain (%), mean, its error, largest  cold (ms), median, largest", end="")
    print("  warm (ms), median, p99  undercut by delays, at most (%)")
    for size in options.sizes:
        for name, turn_rate in TURN_RATES.items():
            for depth in options.depths or [size - 1]:
                line(size, name, turn_rate, depth, options.starts)


def line(size, name, turn_rate, depth, starts):
    """Measure and print a line."""
    study = covey.Study(starts=starts, team_size=size)
    rows = [measure(study.start(k, size), turn_rate, depth) for k in range(starts)]
    gains, cold, warm, least = np.array(rows).T
    error = gains.std(ddof=1) / math.sqrt(starts)
    print(
        f"{size:3d} {name:>4} {depth:6d}  "
        f"{gains.mean():8.2f} ± {error:.2f} {gains.max():8.1f}  "
        f"{np.median(cold):8.1f} {cold.max():8.1f}  "
        f"{np.median(warm):8.2f} {np.percentile(warm, 99):8.2f}  {least.max():8.2f}",
        flush=True,
    )


def measure(start, turn_rate, depth):
    """Return the gain, the times of a plan and of its update, and what delays may take."""
    team = covey.Team(start.positions, start.headings, 0.25, turn_rate)
    disk = covey.PursuerDisk()
    open_loop = covey.plan(team, disk).survival_time
    began = time.process_time()
    tree = covey.plan_contingent(team, disk, depth)
    cold = time.process_time() - began
    gain = tree.survival_time / open_loop - 1.0
    undercut = tree.with_delays.resolution / tree.survival_time
    return 100.0 * gain, 1e3 * cold, 1e3 * updated(tree), 100.0 * undercut


def updated(tree, elapsed=0.01):
    """Return the time that an update of a plan takes after a while in which nobody is captured."""
    from covey.planning.contingent.moment import Moment, fly_on

    moment, turns = fly_on(tree.node.moment, tree.turns, elapsed)
    pursuit = moment.pursuit
    grown = pursuit._replace(first_radius=pursuit.first_radius + elapsed * pursuit.speed)
    rest = tree.node.turns.copy()
    rest[: len(turns)] = turns
    branches = new_branches(len(turns))
    ascend(Moment(moment.evaders, grown), tree.depth, rest, branches)  # the working set is known
    began = time.process_time()
    ascend(Moment(moment.evaders, grown), tree.depth, rest, branches)
    return time.process_time() - began


if __name__ == "__main__":
    main()
