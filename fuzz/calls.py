"""Calls of the public API: legal ones keep their promises, others are told what was wanted."""

from __future__ import annotations

import inspect
import json
import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from hypothesis import strategies as st

import covey
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PURSUERS
from fuzz.legal_games import (
    HEADINGS,
    Size,
    each,
    evaders,
    objectives,
    pursuers,
    sequences,
    sizes,
    states,
    timing,
    turns,
)
from fuzz.mutation import edited
from fuzz.oracle import (
    refusal,
    require,
    require_at_least,
    require_finite,
    require_game,
    require_plan,
)
from fuzz.target import Target
from random_games import time_rounding

MOST_UPDATES = 20
"""Of a game: one with 200 000 of them takes minutes by right."""
ODD_KINDS = {
    "object": object(),
    "complex": 1j,
    "bytes": b"1",
    "set": {1},
    "function": lambda: None,
    "type": float,
    "strings": np.array(["1"]),
    "objects": np.array([None, 1.0]),
    "bools": np.array([True]),
    "dates": np.array(["2020-01-01"], "datetime64[D]"),
    "integer": np.int8(1),
    "scalar": np.array(1.0),
    "masked": np.ma.masked_array([1.0], [True]),
    "iterator": iter(()),
    "team": covey.Team([[1.0, 0.0]], [0.0]),
    "disk": covey.PursuerDisk(),
}
"""What JSON has no word for, as {"kind": name}."""


def check(content):
    """Make the call of a JSON object: {"call": name, "team": {}, "disk": {}, "with": {}}."""
    document = json.loads(content)
    call = CALLS[document["call"]]
    try:
        team = _value(document["team"], covey.Team)
        disk = _value(document["disk"], covey.PursuerDisk)
        others = {key: _argument(key, value) for key, value in document["with"].items()}
        result = _called(call.make, {"team": team, "disk": disk, **others})
    except UnboundError:
        return "no such parameters"
    except covey.InputError as error:
        return refusal(error)
    if result is None:
        return "long by right"
    call.check(team, disk, others, result)
    return document["call"]


class UnboundError(Exception):
    """A call with parameters that the function doesn't have, which is Python's to refuse."""


def _called(function, arguments):
    try:
        bound = inspect.signature(function).bind(**arguments)
    except TypeError as error:
        raise UnboundError from error
    return function(*bound.args, **bound.kwargs)


def _value(value, make=lambda **parts: parts):
    """Return a value of any kind; a table is what `make` makes of it."""
    if isinstance(value, list):
        return [_value(part) for part in value]
    if not isinstance(value, dict):
        return value
    if value.keys() == {"kind"} and str(value["kind"]) in ODD_KINDS:
        return ODD_KINDS[str(value["kind"])]
    return _called(make, {name: _value(part) for name, part in value.items()})


def _argument(key, value):
    """Return an argument: for a table with its name, a strategy or an objective."""
    known = {"evaders": EVADERS, "pursuer": PURSUERS, "objective": OBJECTIVES}.get(key, {})
    if isinstance(value, dict) and str(value.get("name")) in known:
        parameters = {name: part for name, part in value.items() if name != "name"}
        return _value(parameters, known[value["name"]].make)
    return _value(value)


def _plan(team, disk, others, plan):
    require_plan(team, disk, plan)
    upper = covey.plan_for_sequence(team, disk, tuple(range(len(team)))).survival_time
    slack = time_rounding(team, disk, upper)
    require_at_least("a known sequence against a plan", upper + slack, plan.survival_time)


def _guarantee(team, disk, others, guarantee):
    require_finite("guarantee", guarantee.time)
    times = covey.capture_times(team, disk, others["turns"], guarantee.sequence)
    measured = times.sum() if others.get("objective") == covey.TotalSurvival() else times[-1]
    slack = len(team) * time_rounding(team, disk, times[-1])
    require_at_least("its sequence", measured + slack, guarantee.time)
    require_at_least("its sequence", guarantee.time + slack, measured)


def _times(team, disk, others, times):
    require_finite("capture times", times)
    require((np.diff(times, prepend=0.0) >= 0.0).all(), f"capture times {times}")


def _expected(team, disk, others, value):
    require_finite("expected survival", value)
    require(value >= 0.0, f"expected survival {value}")


def _bracket(team, disk, others, bracket):
    require_finite("bracket", bracket.lower, bracket.upper)
    require_at_least("upper end", bracket.upper, bracket.lower)
    require_plan(team, disk, bracket.plan)


def _for_sequence(team, disk, others, plan):
    _times(team, disk, others, plan.capture_times)
    require_finite("turns", plan.turns, plan.goal_headings)
    require((np.abs(plan.turns) <= math.pi).all(), f"turns {plan.turns}")
    straight = covey.capture_times(team, disk, np.zeros(len(team)), plan.sequence)[-1]
    slack = time_rounding(team, disk, straight)
    require_at_least("no turn at all", plan.survival_time + slack, straight)


def _turns(team, disk, others, result):
    require((np.abs(result) <= math.pi).all(), f"turns {result}")


def _game(team, disk, others, game):
    require_game(game)


def _worst(team, disk, others, worst):
    require_finite("worst case", worst.survival_time, worst.value, worst.capture_times)
    require(sorted(worst.sequence) == list(range(len(team))), f"sequence {worst.sequence}")


def _simulate(team, disk, *, update_time=0.01, time_limit=None, **others):
    """Play a game, unless it has many updates."""
    limit = math.inf if time_limit is None else time_limit
    numbers = isinstance(update_time, int | float) and isinstance(limit, int | float)
    if numbers and 0.0 < MOST_UPDATES * update_time < limit:
        return None
    times = {"update_time": update_time, "time_limit": time_limit}
    return _called(covey.simulate, {"team": team, "disk": disk, **times, **others})


def _turns_to(team, goal_headings, disk):
    return covey.turns_to(team, goal_headings)


class Call(NamedTuple):
    """A function, the largest team that is quick, its arguments by name, and what must hold."""

    make: Callable[..., Any]
    most: int
    arguments: Callable[[Size], dict[str, st.SearchStrategy[Any]]]
    check: Callable[..., None]


CALLS = {
    "plan": Call(
        covey.plan,
        9,
        lambda size: {
            "objective": objectives(size.count),
            "seed": st.integers(0, 2**70),
            "starts": st.integers(1, 2),
            "warm_start": st.none() | turns(size.count),
            "tolerance": st.sampled_from((1e-9, 1e-300, 1e50)),
            "time_limit": st.sampled_from((None, 0.0, 1.0)),
        },
        _plan,
    ),
    "guaranteed_survival": Call(
        covey.guaranteed_survival,
        9,
        lambda size: {"turns": turns(size.count), "objective": objectives(size.count)},
        _guarantee,
    ),
    "capture_times": Call(
        covey.capture_times,
        9,
        lambda size: {"turns": turns(size.count), "sequence": sequences(size.count)},
        _times,
    ),
    "expected_survival": Call(
        covey.expected_survival,
        9,
        lambda size: {"turns": turns(size.count), "objective": objectives(size.count)},
        _expected,
    ),
    "bracket": Call(covey.bracket, 3, lambda size: {"starts": st.integers(1, 2)}, _bracket),
    "plan_for_sequence": Call(
        covey.plan_for_sequence,
        9,
        lambda size: {"sequence": sequences(size.count)},
        _for_sequence,
    ),
    "turns_to": Call(
        _turns_to, 9, lambda size: {"goal_headings": each(HEADINGS, size.count)}, _turns
    ),
    "simulate": Call(
        _simulate,
        5,
        lambda size: {
            "evaders": evaders(size.count),
            "pursuer": pursuers(size.count),
            "sensing": st.sampled_from(("hidden", "visible")),
            "seed": st.sampled_from((0, 2**31, 2**70)),
            "timing": timing(size.time),
            "objective": objectives(size.count),
        },
        _game,
    ),
    "worst_case": Call(
        covey.worst_case,
        3,
        lambda size: {
            "update_time": st.sampled_from((0.1, 1.0, 1e6)).map(lambda share: share * size.time),
            "evaders": st.just({"name": "iterative-open-loop", "starts": 2, "restarts": 0}),
        },
        _worst,
    ),
}


@st.composite
def _legal(draw):
    """Draw a call of nasty but legal values."""
    name = draw(st.sampled_from(sorted(CALLS)))
    size = draw(sizes(CALLS[name].most))
    team, disk = draw(states(size))
    arguments = draw(st.fixed_dictionaries(CALLS[name].arguments(size)))
    arguments |= arguments.pop("timing", {})
    return {"call": name, "team": team, "disk": disk, "with": arguments}


@st.composite
def _illegal(draw):
    """Draw a call in which a value or two are others."""
    call = draw(_legal())
    odd = [{"kind": kind} for kind in ODD_KINDS]
    part = draw(st.sampled_from(("team", "disk", "with")))
    new = draw(edited(call[part], (), odd))
    if part != "with" or isinstance(new, dict):
        call[part] = new
    return call


_CASES = (_legal() | _illegal()).map(lambda call: json.dumps(call).encode())
TARGET = Target("calls", ".json", _CASES, check)
