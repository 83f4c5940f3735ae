"""Search for better values: `python -m covey.instances.improve circle-30 --seconds 60`.

Without names all games are searched, one after the other. What is better is written to `values/` at
once, and no plan gets worse. Other seeds find other plans. `--turns FILE` begins with a plan of
one's own: a line for each evader, the signed turn in radians. `--bounds` is for a change of covey
after which the bounds of brackets come out differently.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Sequence
from operator import itemgetter

import numpy as np

from covey.bounds.bracket import LowerEnd, UpperBound, default_depth, upper_bound
from covey.instances.files import instance_names, require_instance, values_path
from covey.instances.instance import KnownBracket, KnownPlan
from covey.instances.load import load_instance, load_state
from covey.instances.text import values_text
from covey.instances.upper_end import upper_end_from
from covey.model import InputError, PursuerDisk, Team
from covey.model.angles import wrap_angle
from covey.model.validation import Floats, checked_array, read_only
from covey.planning import guaranteed_survival, plan, plan_contingent

_STARTS = 100
"""Starts of each search: for large teams more than by default, until the time is used up."""


def improve(
    name: str, seconds: float, seed: int, *, bounds: bool = False, turns: Floats | None = None
) -> bool:
    """Search for a better plan of a game for so many seconds; return whether there is one.

    The search begins with the best plan known, and with `turns` (N,). Each proof of what a plan
    guarantees may take as long again. The bounds of the bracket are computed only where there are
    none yet, or anew for `bounds`.
    """
    team, disk = load_state(name)
    known = load_instance(name) if values_path(name).exists() else None
    first = [] if known is None else [known.plan]
    if turns is not None:
        turns = checked_array("turns", turns, (len(team),))
        if np.abs(turns).max() > math.pi:
            raise InputError("turns: expected turns in [-π, π]")
        first.append(_with_guarantee(team, disk, turns, seconds))
    elif known is None:
        first.append(_with_guarantee(team, disk, 0.0 * team.headings, seconds))
    best = _better_plan(team, disk, max(first, key=_worth), seconds, seed)
    bracket = _bracket(team, disk, best, None if known is None else known.bracket, bounds)
    values_path(name).write_text(values_text(name, best, bracket), encoding="utf-8")
    return known is None or best != known.plan


def _better_plan(
    team: Team, disk: PursuerDisk, best: KnownPlan, seconds: float, seed: int
) -> KnownPlan:
    until = time.perf_counter() + seconds
    while (left := until - time.perf_counter()) > 0.0:
        found = plan(team, disk, seed=seed, starts=_STARTS, time_limit=left, warm_start=best.turns)
        if found.survival_time > best.survival_time:
            best = max(_with_guarantee(team, disk, found.turns, seconds), best, key=_worth)
        seed += 1
    if not best.exact:
        best = max(_with_guarantee(team, disk, best.turns, seconds), best, key=_worth)
    return best


def _worth(known: KnownPlan) -> tuple[float, float]:
    return known.survival_time, -known.upper


def _with_guarantee(team: Team, disk: PursuerDisk, turns: Floats, seconds: float) -> KnownPlan:
    """Return turns with what they guarantee, as far as so many seconds prove it."""
    found = guaranteed_survival(team, disk, turns, time_limit=seconds)
    goals = read_only(wrap_angle(team.headings + turns))
    return KnownPlan(turns, goals, found.time, found.sequence, found.upper)


def _bracket(
    team: Team, disk: PursuerDisk, best: KnownPlan, known: KnownBracket | None, anew: bool
) -> KnownBracket:
    """Return the bracket that is known, or a new one, with what the plan guarantees."""
    lowers = [(best.survival_time, LowerEnd.OPEN_LOOP, 0)]
    if known is None or anew:
        lowers += _contingent(team, disk)
        uppers = _upper_bounds(team, disk, best)
    else:
        lowers.append((known.lower, known.lower_by, known.depth))
        uppers = [UpperBound(known.upper, known.upper_by, known.sequence, known.start)]
    (lower, lower_by, depth), end = max(lowers, key=itemgetter(0)), min(uppers, key=itemgetter(0))
    return KnownBracket(lower, lower_by, depth, end.time, end.by, end.sequence, end.start)


def _contingent(team: Team, disk: PursuerDisk) -> list[tuple[float, LowerEnd, int]]:
    depth = default_depth(len(team))
    if depth == 0:
        return []
    delayed = plan_contingent(team, disk, depth).with_delays
    return [(delayed.survival_time, LowerEnd.CONTINGENT, depth)]


def _upper_bounds(team: Team, disk: PursuerDisk, best: KnownPlan) -> list[UpperBound]:
    """Return the bound and, for a disk, the one from where that pursuer starts in it."""
    end = upper_bound(team, disk, [best.worst_sequence])
    if disk.radius == 0.0:
        return [end]
    return [end, upper_end_from(team, disk, end.start, end.sequence)]


def _numbers_in(path: str) -> Floats:
    try:
        return np.loadtxt(path, ndmin=1)
    except (OSError, ValueError) as error:
        raise argparse.ArgumentTypeError(
            f"{path}: expected a number in each line: {error}"
        ) from None


def main(words: Sequence[str] | None = None) -> None:
    """Search the games that are named, and print a line for each."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="by default all games")
    parser.add_argument("--seconds", type=float, default=10.0, help="for each game")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--turns", type=_numbers_in, help="file with a plan of one game")
    parser.add_argument("--bounds", action="store_true", help="compute the brackets anew")
    options = parser.parse_args(words)
    try:
        for name in [*map(require_instance, options.names)] or instance_names():
            better = improve(
                name, options.seconds, options.seed, bounds=options.bounds, turns=options.turns
            )
            print(load_instance(name), "better" if better else "", flush=True)
    except InputError as error:
        parser.error(str(error))


if __name__ == "__main__":
    main()
