"""All teams and pursuers that a soak knows, and what each of them promises."""

from __future__ import annotations

import bisect
import functools
import itertools
import math
from typing import Any, NamedTuple

import numpy as np

import covey
from covey.bounds import solve_two_evaders
from covey.players import DelayedSequence, DownhillPursuer
from soak import custom_pursuers

FASTEST = 0.95
"""Speed of most evaders, relative to the pursuer's, at most; a few are nearly as fast as that."""

LARGEST_TREE = 5
"""Evaders up to which a team answers captures: a tree of more takes seconds."""


class Player(NamedTuple):
    """A strategy, and what is known of it."""

    name: str
    strategy: Any
    compiled: bool = False  # can play in a compiled game
    ends: bool = False  # a pursuer that captures all in bounded time
    assures: bool = False  # a pursuer that assures a time by which everybody is captured
    placed: bool = False  # a pursuer that has a position even where it is hidden
    keeps_plan: bool = False  # a team that flies its first plan to the end
    replans: bool = False  # a team whose later plans never promise less
    answers: bool = False  # a team whose plans answer captures


class Setting(NamedTuple):
    """What players are drawn for."""

    team: covey.Team
    disk: covey.PursuerDisk
    sensing: str
    nominal_time: float
    update_time: float


def lasts(team, disk):
    """Whether an evader is so fast that a game may take thousands of times its nominal time."""
    return bool(team.speeds.max() > FASTEST * disk.speed)


def draw(generator, setting, interpreted):
    """Return a team and a pursuer; at least one plays in Python if `interpreted`."""
    of_the_team = interpreted and generator.random() < 0.5
    teams = INTERPRETED_TEAMS if of_the_team else COMPILED_TEAMS
    in_python = interpreted and (not of_the_team or generator.random() < 0.3)
    pursuers = _interpreted_pursuers(setting) if in_python else COMPILED_PURSUERS
    evaders, pursuer = pick(generator, teams), pick(generator, pursuers)
    return evaders(generator, setting), pursuer(generator, setting)


def draw_answering(generator, setting):
    """Return a team that answers captures, and a pursuer; every pursuer is equally frequent."""
    pursuers = [*COMPILED_PURSUERS, *_interpreted_pursuers(setting)]
    pursuer = pursuers[generator.integers(len(pursuers))]
    return _contingent(generator, setting), pursuer(generator, setting)


def _interpreted_pursuers(setting):
    """Those that can play: a hidden disk can't be steered, delays are for hidden pursuers."""
    if is_downhill(setting):
        return {downhill: 1}
    other = _roaming if setting.sensing == "hidden" else _delayed
    return {kind: weight for kind, weight in INTERPRETED_PURSUERS.items() if kind is not other}


def pick(generator, weights):
    """Return a key, drawn by the weights."""
    kinds, bounds = list(weights), list(itertools.accumulate(weights.values()))
    return kinds[bisect.bisect(bounds, generator.random() * bounds[-1], hi=len(kinds) - 1)]


def _open_loop(generator, setting):
    strategy = covey.OpenLoop(starts=int(generator.integers(1, 4)))
    return Player("open loop", strategy, compiled=True, keeps_plan=True)


def _iterative(generator, setting):
    interval = generator.choice([0.0, 0.0, 2.0, 3.5]) * setting.update_time
    strategy = covey.IterativeOpenLoop(
        starts=int(generator.integers(1, 4)),
        restarts=int(generator.integers(0, 3)),
        replan_time=float(interval),
    )
    return Player("iterative open loop", strategy, compiled=True, replans=True)


def _hold_course(generator, setting):
    return Player("hold course", covey.HoldCourse(), keeps_plan=True)


def _straight_away(generator, setting):
    return Player("straight away", covey.StraightAway(replan_time=_interval(generator, setting)))


def _constant_heading(generator, setting):
    return Player("constant heading", covey.ConstantHeading(starts=1, restarts=1))


def _contingent(generator, setting):
    most = 2 if len(setting.team) <= LARGEST_TREE else 0
    strategy = covey.Contingent(int(generator.integers(0, most + 1)), _interval(generator, setting))
    return Player("contingent", strategy, answers=True)


def _known_sequence(generator, setting):
    order = generator.permutation(len(setting.team)) if generator.random() < 0.5 else None
    strategy = covey.KnownSequence(order, replan_time=_interval(generator, setting))
    return Player("known sequence", strategy)


def _largest_distance(generator, setting):
    strategy = covey.LargestDistance(replan_time=_interval(generator, setting))
    return Player("largest distance", strategy)


def _smallest_danger(generator, setting):
    strategy = covey.SmallestDanger(replan_time=2.0 * setting.update_time)
    return Player("smallest danger", strategy)


def _interval(generator, setting):
    return float(generator.choice([0.0, 2.0])) * setting.update_time


def _committed(generator, setting):
    margin = float(generator.choice([0.01, 0.1, math.inf]))
    return Player(f"committed, margin {margin:g}", covey.CommittedPursuer(margin), compiled=True)


def _uncommitted(generator, setting):
    return Player("uncommitted", covey.UncommittedPursuer(), compiled=True)


def _fixed_sequence(generator, setting):
    strategy = covey.FixedSequence(generator.permutation(len(setting.team)))
    return Player("fixed sequence", strategy, compiled=True, ends=True)


def _best_sequence(generator, setting):
    return Player("best sequence", covey.BestSequence(), compiled=True, ends=True)


def _assured(generator, setting):
    return Player("assured", covey.AssuredPursuer(), ends=True, assures=True)


def _random_sequence(generator, setting):
    return Player("random sequence", covey.RandomSequence(), compiled=True, ends=True)


def _flying(generator, setting):
    angle, share = generator.uniform(-math.pi, math.pi), generator.uniform(0.0, 1.0)
    offset = (share * math.cos(angle), share * math.sin(angle))
    margin = float(generator.choice([0.01, math.inf]))
    return Player("flying", covey.FlyingPursuer(margin, offset), placed=True)


def _nearest_first(generator, setting):
    return Player("nearest first", covey.NearestFirst())


def _delayed(generator, setting):
    count = len(setting.team)
    delays = setting.nominal_time / 4 * generator.choice([0.0, 0.3, 1.0], count)
    strategy = DelayedSequence(generator.permutation(count), delays)
    return Player("delayed sequence", strategy)


class Afresh:
    """A strategy from a function that makes a policy with a memory: a new one for each game."""

    def __init__(self, make, *arguments):
        self._make, self._arguments = make, arguments

    def __repr__(self):
        return f"{self._make.__name__}{self._arguments}"

    def start(self, seed):
        """Return the policy of one game."""
        return self._make(*self._arguments)


def _redrawing(generator, setting):
    return Player("redrawing", Afresh(custom_pursuers.redrawing, _seed(generator)))


def _farthest_first(generator, setting):
    return Player("farthest first", Afresh(custom_pursuers.farthest_first, 0))


def _waiting(generator, setting):
    hesitation = setting.nominal_time / 2
    strategy = Afresh(custom_pursuers.waiting, _seed(generator), hesitation)
    return Player("waiting", strategy)


def _roaming(generator, setting):
    hesitation = setting.nominal_time / 2
    strategy = Afresh(custom_pursuers.roaming, _seed(generator), hesitation)
    return Player("roaming", strategy)


def _unseen(generator, setting):
    strategy = custom_pursuers.Unseen(_seed(generator), setting.nominal_time / 2)
    return Player("roaming unseen", strategy, placed=True)


def _seed(generator):
    return int(generator.integers(2**32))


def downhill(generator, setting):
    return Player("downhill", DownhillPursuer(_two_evader_value()))


@functools.cache
def _two_evader_value():
    return solve_two_evaders(DOWNHILL_SPEEDS, cells=32)


DOWNHILL_SPEEDS = (0.25, 0.5)
"""Relative to the pursuer's, of the one game that `DownhillPursuer` has been given the value of."""


def downhill_game(team, disk):
    """Return team, disk and sensing of the game that `DownhillPursuer` plays."""
    speeds = disk.speed * np.array(DOWNHILL_SPEEDS)
    point = covey.PursuerDisk(disk.center, 0.0, disk.speed)
    return covey.Team(team.positions, team.headings, speeds, math.inf), point, "visible"


def is_downhill(setting):
    """Whether this is the game that `DownhillPursuer` plays."""
    return (
        setting.sensing == "visible"
        and setting.disk.radius == 0.0
        and setting.disk.capture_radius == 0.0
        and np.array_equal(setting.team.speeds, setting.disk.speed * np.array(DOWNHILL_SPEEDS))
    )


COMPILED_TEAMS = {_iterative: 60, _open_loop: 40}
INTERPRETED_TEAMS = {
    _hold_course: 3,
    _straight_away: 3,
    _constant_heading: 3,
    _contingent: 3,
    _known_sequence: 1,
    _largest_distance: 2,
    _smallest_danger: 1,
}
COMPILED_PURSUERS = {
    _committed: 40,
    _uncommitted: 15,
    _fixed_sequence: 20,
    _random_sequence: 20,
    _best_sequence: 1,
}
INTERPRETED_PURSUERS = {
    _assured: 3,
    _flying: 4,
    _nearest_first: 3,
    _delayed: 3,
    _redrawing: 2,
    _farthest_first: 2,
    _waiting: 2,
    _roaming: 2,
    _unseen: 2,
}
