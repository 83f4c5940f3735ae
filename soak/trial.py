"""What is checked of one case: each check's error, and what the check is allowed."""

from __future__ import annotations

import itertools
import math
import time
import warnings
from typing import NamedTuple

import numpy as np

import covey
from covey import simulation
from covey.planning.expectation import value_of_plan
from covey.players import survival
from covey.players.compiled import checked_settings
from soak import contingent, legal_game
from soak.case import Case, draw
from soak.errors import difference, exactly, largest_fall, shortfall
from soak.players import lasts
from soak.same_games import differences

TOLERANCE = 1e-9
"""Relative, for times; of an angle in radians; of a place relative to the extent of the game."""
FAR = 100.0
"""Sizes of a game from the origin, from which on places of the record have lost two digits."""
SAMPLES = 10
"""Moments between two rows at which somebody might have been touched."""
BRUTE_FORCE = 4
"""Evaders up to which every sequence is tried."""
BRACKETED = 5
"""Evaders up to which brackets are taken: a bracket of more takes a fifth of a second."""


class ViolationError(Exception):
    """A game that breaks a rule; the message has what a person needs to play it again."""

    def __init__(self, case: Case, check: str, error: float) -> None:
        super().__init__(f"{check}: {error:.3g}, allowed {TOLERANCE:g}\n{describe(case)}")
        self.seed, self.check, self.error = case.seed, check, error


class Trial(NamedTuple):
    """A game that was played and checked."""

    case: Case
    errors: dict[str, float]  # the largest that each check found
    seconds: dict[str, float]  # what each part took
    rows: int
    stopped: bool  # at its time limit


def play(seed):
    """Draw the case of a seed, play it and check it.

    Raises
    ------
    ViolationError
        If an error is larger than allowed, or covey raised an exception.
    """
    case = draw(seed)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            trial = _checked(case)
    except Exception as error:
        raise ViolationError(case, f"{type(error).__name__}: {error}", math.nan) from error
    for name, error in trial.errors.items():
        if not error <= TOLERANCE:
            raise ViolationError(case, name, error)
    return trial


def _checked(case):
    clock, errors = _Clock(), {}
    game = covey.simulate(case.team, case.disk, **_players(case), **case.settings())
    clock.lap("game")
    limit = math.inf if case.time_limit is None else case.time_limit
    errors.update(legal_game.errors(game, limit, case.pursuer.placed, SAMPLES))
    errors.update(promises(case, game))
    clock.lap("legality and promises")
    for name, check in CHECKS.items():
        if name in case.checks:
            errors.update(check(case, game))
            clock.lap(name)
    stopped = game.status is not covey.GameStatus.ALL_CAPTURED
    return Trial(case, errors, clock.seconds, len(game.times), stopped)


def promises(case, game):
    """The first plan's promise is kept, and later ones never promise less."""
    team, last = case.evaders, isinstance(case.objective, covey.LastCapture)
    found = {}
    if team.keeps_plan or (team.replans and last):
        found["guarantee is kept"] = shortfall(game.guarantee, game.survival_time)
        until = game.times + game.guarantees
        found["promises never fall"] = largest_fall(until) / float(until.max() or 1.0)
    expected = isinstance(case.objective, covey.ExpectedSurvival)
    if (team.keeps_plan or team.replans) and not expected:
        found["value is kept"] = shortfall(game.planned_value, game.value)
    if case.time_limit is None:
        # covey's own limit of time is one within which such a pursuer has captured everybody.
        in_time = game.status is not covey.GameStatus.TIME_LIMIT
        found["a fixed order comes to its end"] = exactly(in_time)
    if team.answers:
        found |= contingent.promises(case, game)
    return found | _assurances(case, game)


def _assurances(case, game):
    """No plan is above the pursuer's first assurance, which never rises, and is kept."""
    if not case.pursuer.assures:
        return {}
    until, lived = game.assurances, game.times[-1]
    planned = covey.plan(case.team, case.disk, seed=case.seed, starts=2).survival_time
    return {
        "no plan above the first assurance": shortfall(planned, until[0]),
        "assurance never rises": largest_fall(-until) / float(until.max() or 1.0),
        "done by the last assurance": shortfall(lived, until[-1]),
    }


def played_again(case, game):
    """The same bits, and without a record the same outcome."""
    players, settings = _players(case), case.settings()
    again = covey.simulate(case.team, case.disk, **players, **settings)
    outcome = survival(case.team, case.disk, **players, **settings)
    same = all(map(np.array_equal, outcome, game.outcome()))
    return {"the same game twice": exactly(differences(game, again) == [] and same)}


def played_both_ways(case, game):
    """The compiled game, by the loop in Python."""
    if not (case.evaders.compiled and case.pursuer.compiled):
        return {}
    settings = checked_settings(case.team, case.disk, **case.settings())
    other = simulation.play(case.team, case.disk, **_players(case), settings=settings)
    return {"compiled and Python games agree": exactly(differences(game, other) == [])}


def promise_of_a_row(case, game):
    """Computed anew from the state and the plan that the row shows, where rounding allows it."""
    if np.abs(case.disk.center).max() > FAR * np.ptp(game.evader_positions, axis=(0, 1)).max():
        return {}
    row = case.seed % len(game.times)
    numbers = np.sort(game.critical_sequences[row][game.critical_sequences[row] >= 0])
    if len(numbers) == 0:
        return {}
    team = covey.Team(
        game.evader_positions[row, numbers],
        game.evader_headings[row, numbers],
        case.team.speeds[numbers],
        case.team.turn_rates[numbers],
    )
    disk = covey.PursuerDisk(
        game.disk_centers[row], game.disk_radii[row], case.disk.speed, case.disk.capture_radius
    )
    found = covey.guaranteed_survival(team, disk, game.evader_turns[row, numbers])
    until, recorded = game.times[row] + found.time, game.times[row] + game.guarantees[row]
    return {"promise of a row": difference(until, recorded)}


def plan_by_itself(case, game):
    """Its value by the dynamic programme, and by every sequence; the first start is the least."""
    team, disk, objective = case.team, case.disk, case.objective
    plan = covey.plan(team, disk, objective=objective, seed=case.seed, starts=3)
    fewer = covey.plan(team, disk, objective=objective, seed=case.seed, starts=1)
    found = {
        "value of a plan": difference(value_of_plan(team, disk, plan.turns, objective), plan.value),
        "more starts never give less": shortfall(fewer.value, plan.value),
    }
    guarantee = covey.guaranteed_survival(team, disk, plan.turns).time
    found["survival time of a plan"] = difference(guarantee, plan.survival_time)
    if len(team) <= BRUTE_FORCE:
        orders = itertools.permutations(range(len(team)))
        ends = [covey.capture_times(team, disk, plan.turns, order)[-1] for order in orders]
        found["least of all sequences"] = difference(min(ends), plan.survival_time)
    return found


def bracketed(case, game):
    """No plan is above the upper end, which `bracket` itself lifts to its own plan's value."""
    team, disk = case.team, case.disk
    if len(team) > BRACKETED:
        return {}
    found = covey.bracket(team, disk, seed=case.seed, starts=2)
    other = covey.plan(team, disk, seed=case.seed + 1, starts=8)
    agile = covey.Team(team.positions, team.headings, team.speeds, math.inf)
    announced = covey.plan_for_sequence(agile, disk, found.sequence)
    return {
        "lower end below the upper": shortfall(found.lower, found.upper),
        "another plan below the upper end": shortfall(other.survival_time, found.upper),
        "plans below an announced sequence": shortfall(
            max(found.lower, other.survival_time), announced.survival_time
        ),
    }


def worst_case(case, game):
    """The promise holds in it, and the game with its sequence is that game."""
    expected = isinstance(case.objective, covey.ExpectedSurvival)
    short = len(case.team) <= BRUTE_FORCE and not lasts(case.team, case.disk)
    if not case.evaders.compiled or expected or not short:
        return {}
    players = {"evaders": case.evaders.strategy}
    settings = {name: case.settings()[name] for name in ("update_time", "seed", "objective")}
    worst = covey.worst_case(case.team, case.disk, **players, **settings)
    players["pursuer"] = covey.FixedSequence(worst.sequence)
    same = survival(case.team, case.disk, **players, **settings)
    return {
        "worst case above the promise": shortfall(same.planned_value, worst.value),
        "worst case is a game": difference(worst.value, same.value),
    }


CHECKS = {
    "again": played_again,
    "both ways": played_both_ways,
    "rows": promise_of_a_row,
    "plan": plan_by_itself,
    "bracket": bracketed,
    "worst case": worst_case,
    "answers": contingent.plans,
}


def describe(case):
    """What is played, in full precision."""
    team, disk = case.team, case.disk
    return "\n".join(
        [
            f"seed {case.seed}",
            f"team = covey.Team({team.positions.tolist()}, {team.headings.tolist()}, "
            f"{team.speeds.tolist()}, {team.turn_rates.tolist()})",
            f"disk = covey.PursuerDisk({disk.center.tolist()}, {disk.radius!r}, {disk.speed!r}, "
            f"{disk.capture_radius!r})",
            f"evaders: {case.evaders.name}, {case.evaders.strategy!r}",
            f"pursuer: {case.pursuer.name}, {case.pursuer.strategy!r}",
            *(f"{name} = {value!r}" for name, value in case.settings().items()),
        ]
    )


class _Clock:
    """Seconds of each part."""

    def __init__(self):
        self.seconds = {}
        self._last = time.perf_counter()

    def lap(self, part):
        now = time.perf_counter()
        self.seconds[part] = self.seconds.get(part, 0.0) + now - self._last
        self._last = now


def _players(case):
    return {"evaders": case.evaders.strategy, "pursuer": case.pursuer.strategy}
