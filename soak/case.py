"""One random game: who plays, how, and which of the costly checks it gets; all from one seed."""

from __future__ import annotations

import itertools
import math
from typing import Any, NamedTuple

import numpy as np

import covey
from covey.model.angles import away_from
from soak import players

SIZES = {1: 12, 2: 26, 3: 28, 4: 18, 5: 12, 6: 2, 7: 1, 8: 0.6, 9: 0.15, 10: 0.1, 11: 0.1, 12: 0.05}
"""Evaders in a team, and how often, in per cent."""
SHORT = 5
"""Evaders up to which a game may last as long as it takes; else three times its nominal time."""
PLACES = [0.0, 30.0, 1e5]
"""How far from the origin a game may be, in its own length."""
SHARES = {
    "interpreted": 0.08,  # a team or a pursuer that plays in Python, one decision at a time
    "fine": 0.02,  # some hundred updates until the last capture, instead of about ten
    "again": 0.05,  # played twice
    "both ways": 0.03,  # compiled, then by the loop in Python
    "rows": 0.1,  # the promise of a row is computed anew
    "plan": 0.1,  # the plan by itself, against every sequence where these are few
    "bracket": 0.01,
    "worst case": 0.02,
    "answers": 0.01,  # plans that answer captures, one depth after the other
}
"""How many of the games, of those that the check is meant for, get it."""


class Case(NamedTuple):
    """A game to play, and what else is checked."""

    seed: int
    team: covey.Team
    disk: covey.PursuerDisk
    evaders: players.Player
    pursuer: players.Player
    sensing: str
    objective: Any
    update_time: float
    time_limit: float | None
    checks: frozenset[str]  # of those named in `SHARES`

    def settings(self):
        """What `covey.simulate` is told besides the players."""
        return {
            "sensing": self.sensing,
            "update_time": self.update_time,
            "seed": self.seed,
            "time_limit": self.time_limit,
            "objective": self.objective,
        }


def draw(seed):
    """Return the case of a seed."""
    generator = np.random.default_rng(seed)
    given = generator.random(len(SHARES)) < np.array(list(SHARES.values()))
    checks = frozenset(itertools.compress(SHARES, given))
    count = players.pick(generator, SIZES)
    interpreted = "interpreted" in checks
    length, speed = 10.0 ** generator.uniform(-4.0, 4.0, 2)
    team, disk = _draw_team(generator, count, length, speed), _draw_disk(generator, length, speed)
    place = generator.choice(PLACES, p=[0.7, 0.2, 0.1]) * generator.uniform(-length, length, 2)
    team, disk = team.moved(place), disk.moved(place)
    sensing = str(generator.choice(["hidden", "visible"]))
    if interpreted and count == 2 and generator.random() < 0.02:
        team, disk, sensing = players.downhill_game(team, disk)
    objective = _draw_objective(generator, count)
    nominal = nominal_time(team, disk) or float(length / speed)
    updates = _draw_updates(generator, interpreted, "fine" in checks)
    update_time = float(nominal / updates)
    setting = players.Setting(team, disk, sensing, nominal, update_time)
    evaders, pursuer = players.draw(generator, setting, interpreted)
    to_the_end = pursuer.ends and count <= SHORT and not players.lasts(team, disk)
    return Case(
        seed,
        team,
        disk,
        evaders,
        pursuer,
        sensing,
        objective,
        update_time,
        None if to_the_end else 3.0 * nominal,
        checks,
    )


def _draw_team(generator, count, length, speed):
    """Evaders alike as in the paper, or mixed over orders of magnitude, or of simple motion."""
    speeds, rates = np.full(count, 0.25), np.full(count, math.pi / 2)
    if generator.random() < 0.6:
        speeds = players.FASTEST * 10.0 ** generator.uniform(
            -generator.choice([0.3, 1.0, 4.0]), 0.0, count
        )
        speeds[generator.random(count) < 0.1] = 0.0
        fast = generator.random(count) < 0.02
        speeds[fast] = 1.0 - 10.0 ** generator.uniform(-4.0, -1.0, fast.sum())
        rates = 10.0 ** generator.uniform(-3.0, 3.0, count)
        rates[generator.random(count) < 0.15] = math.inf
        rates[generator.random(count) < 0.1] = 0.0
    if generator.random() < 0.15:
        rates = np.full(count, math.inf)
    places = generator.uniform(-0.5, 0.5, (count, 2)) * 10.0 ** -generator.exponential(0.3)
    if generator.random() < 0.05:
        places[:] = places[0]
    shift = generator.uniform(-1.0, 1.0, 2) * generator.choice(
        [0.0, 3.0, 30.0], p=[0.7, 0.25, 0.05]
    )
    headings = generator.uniform(-math.pi, math.pi, count)
    return covey.Team(length * (places + shift), headings, speed * speeds, speed / length * rates)


def _draw_disk(generator, length, speed):
    """A point or a disk, up to one that holds the whole team, with or without reach."""
    radius = 10.0 ** generator.uniform(-3.0, 0.3) if generator.random() < 0.5 else 0.0
    reach = 10.0 ** generator.uniform(-4.0, -0.7) if generator.random() < 0.5 else 0.0
    center = length * generator.uniform(-0.3, 0.3, 2)
    return covey.PursuerDisk(center, length * radius, speed, length * reach)


def _draw_objective(generator, count):
    kind = generator.random()
    if kind < 0.65:
        return covey.LastCapture()
    if kind < 0.88:
        return covey.TotalSurvival()
    measure = str(generator.choice(["last", "total"]))
    if count <= 3 and generator.random() < 0.5:
        return covey.ExpectedSurvival(measure=measure)
    drawn = {tuple(generator.permutation(count).tolist()) for _ in range(4)}
    sequences = sorted(drawn)
    return covey.ExpectedSurvival(sequences, generator.uniform(0.1, 1.0, len(sequences)), measure)


def nominal_time(team, disk):
    """How long the team survives that flies straight away from the disk's centre."""
    turns = covey.turns_to(team, away_from(disk.center, team.positions))
    return covey.guaranteed_survival(team, disk, turns).time


def _draw_updates(generator, interpreted, fine):
    """How many updates the nominal time takes."""
    if interpreted:
        return generator.uniform(1.0, 6.0)
    return 10.0 ** (generator.uniform(1.5, 2.5) if fine else generator.uniform(0.2, 1.3))
