"""A wrong strategy of either side is told what is wrong with it, and what to do."""

from __future__ import annotations

import math
import random
import re

import numpy as np
import pytest

import covey
from covey.players.names import PURSUERS, TEAMS
from covey.testing import check_strategy

_random = random.Random(0)


class Strategy:
    """A strategy that makes its policy by a function of the seed."""

    def __init__(self, start):
        self._start = start

    def start(self, seed):
        return self._start(seed)


class NeedsNoSeed:
    def start(self):
        return still


class Remembers:
    """Keeps what it remembers in the strategy, where the next game finds it."""

    def __init__(self):
        self.decided = 0

    def start(self, seed):
        return self._decide

    def _decide(self, situation):
        self.decided += 1
        return [0.001 * self.decided] * len(situation.evaders)


class Nameless:
    def start(self, seed):
        return still

    def describe(self):
        return {"gain": 3}


class OutsideTheDisk:
    def place(self, disk):
        return disk.center + 2.0 * disk.radius + 1.0

    def start(self, seed):
        return first


def still(situation):
    return np.zeros(len(situation.evaders))


def first(situation):
    return covey.Chase(situation.evaders[:1])


def changes(situation):
    situation.team.positions[0] = 0.0
    return still(situation)


TEAM_FAULTS = {
    "a class": (Strategy, "expected a strategy, got the class Strategy", "make a value of it"),
    "no strategy": (3, "expected a strategy", "method start(seed)"),
    "an unknown name": ("open-lop", "expected one of open-loop", "got 'open-lop'"),
    "a start without a seed": (NeedsNoSeed(), "start(seed) raised TypeError", "called once for"),
    "a start that returns nothing": (
        Strategy(lambda seed: None),
        "start(seed) returned None",
        "return a function of a Situation",
    ),
    "a policy without a situation": (
        Strategy(lambda seed: lambda: 0.0),
        "deciding raised TypeError",
        "called with one argument, a Situation",
    ),
    "an exception": (
        lambda situation: still(situation) + 1 / (len(situation.evaders) - 2),
        "ZeroDivisionError: division by zero, at time",
        "2 evaders alive; the traceback above says where",
    ),
    "a change of the situation": (changes, "read-only", "copy the array first"),
    "nothing decided": (lambda situation: None, "expected numbers, got None", "one signed turn"),
    "turns of the whole team": (
        lambda situation: np.zeros(3),
        "shape (2,), got shape (3,)",
        "one signed turn for each of the 2 evaders alive",
    ),
    "a turn and a half": (
        lambda situation: 9.0 + still(situation),
        "expected radians in [-π, π]",
        "covey.turns_to(situation.team, goal_headings)",
    ),
    "no number": (
        lambda situation: math.nan * still(situation),
        "expected finite numbers",
        "covey.turns_to",
    ),
    "chance without the seed": (
        Strategy(lambda seed: lambda situation: _random.random() + still(situation)),
        "was played differently the second time",
        "numpy.random.default_rng(seed)",
    ),
    "chance in a function": (
        lambda situation: _random.random() + still(situation),
        "was played differently the second time",
        "write a class whose start(seed)",
    ),
    "memory in the strategy": (
        Remembers(),
        "was played differently the second time",
        "keep what is remembered in the policy",
    ),
    "a description without a name": (Nameless(), "describe() returned {'gain': 3}", "with a name"),
}

PURSUER_FAULTS = {
    "a number": (lambda situation: 0, "expected Chase or Fly, got 0", "covey.Chase((i, ...))"),
    "nobody chased": (
        lambda situation: covey.Chase(()),
        "expected a sequence of living evaders [0, 1, 2], got []",
        "name living evaders",
    ),
    "the captured chased": (
        lambda situation: covey.Chase((0, 1, 2)[: len(situation.evaders)]),
        "Chase: expected a sequence of living evaders [",
        "name living evaders, each once",
    ),
    "too fast": (
        lambda situation: covey.Fly((2.0, 0.0)),
        "Fly: expected a speed of at most 1, got 2",
        "situation.disk.speed = 1",
    ),
    "a hidden pursuer steered": (
        lambda situation: covey.Fly((0.5, 0.0)),
        "known as a disk only and can't be steered",
        "return Chase((...))",
    ),
    "a start outside the disk": (OutsideTheDisk(), "expected a point of the disk", "from its c"),
    "an assurance that rises": (
        lambda situation: covey.Chase(situation.evaders[:1], 100.0 + situation.time),
        "assurance of the pursuer",
        "it never rises",
    ),
}


@pytest.mark.parametrize("fault", TEAM_FAULTS)
def test_a_wrong_team_is_told(fault):
    strategy, what, advice = TEAM_FAULTS[fault]
    with pytest.raises(covey.InputError, match=f"^evaders.*?{re.escape(what)}") as error:
        check_strategy(evaders=strategy)
    assert advice in str(error.value)


@pytest.mark.parametrize("fault", PURSUER_FAULTS)
def test_a_wrong_pursuer_is_told(fault):
    strategy, what, advice = PURSUER_FAULTS[fault]
    with pytest.raises(covey.InputError, match=re.escape(what)) as error:
        check_strategy(pursuer=strategy)
    assert "pursuer" in str(error.value)
    assert advice in str(error.value)


def test_what_cannot_be_copied_is_checked_all_the_same():
    with pytest.raises(covey.InputError, match=r"^evaders: "):
        check_strategy(evaders=re)

    class Locked(covey.StraightAway):
        def __deepcopy__(self, memo):
            raise TypeError("a lock can't be copied")

    check_strategy(evaders=Locked())


def test_an_exception_leads_to_the_line_that_raised_it():
    with pytest.raises(covey.InputError) as error:
        check_strategy(evaders=TEAM_FAULTS["an exception"][0])
    assert isinstance(error.value.__cause__, ZeroDivisionError)


def test_a_pursuer_that_is_made_for_what_is_seen_may_be_checked_so():
    def east(situation):
        return covey.Fly((0.5, 0.0))

    check_strategy(pursuer=east, sensing="visible")
    with pytest.raises(covey.InputError, match="sensing: expected one of hidden, visible"):
        check_strategy(pursuer=east, sensing="seen")


@pytest.mark.parametrize("given", [{}, {"evaders": still, "pursuer": first}])
def test_one_side_is_checked_at_a_time(given):
    with pytest.raises(covey.InputError, match="expected one of them to be checked, got"):
        check_strategy(**given)


@pytest.mark.parametrize(
    "given",
    [
        {"evaders": still},
        {"pursuer": first},
        {"evaders": Strategy(lambda seed: still)},
        {"pursuer": Strategy(lambda seed: first)},
    ],
)
def test_nothing_is_wrong_with_a_right_strategy(given):
    assert check_strategy(**given) is None


@pytest.mark.parametrize("name", sorted(TEAMS))
def test_nothing_is_wrong_with_the_teams_that_come_along(name):
    check_strategy(evaders=name)


@pytest.mark.parametrize("name", sorted({*PURSUERS} - {"fixed-sequence"}))
def test_nothing_is_wrong_with_the_pursuers_that_come_along(name):
    check_strategy(pursuer=name)
