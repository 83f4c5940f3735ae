"""Computes every number that is known about a game again, and says which do not hold."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import zip_longest
from typing import NamedTuple

import numpy as np

from covey.bounds.bracket import LowerEnd
from covey.instances.files import values_path
from covey.instances.instance import Instance
from covey.instances.text import values_text
from covey.instances.upper_end import upper_end_from
from covey.model.angles import wrap_angle
from covey.planning import capture_times, guaranteed_survival, plan_contingent

_ROUNDING = 1e-9
"""Relative: by how much a number may differ when it is computed again."""

_ASCENT = 1e-6
"""The same for what an ascent comes to, which ends where it gains no more."""


class Findings(NamedTuple):
    """What a check found: mistakes, and what the time limit left undecided; a sentence each."""

    mistakes: list[str]
    undecided: list[str]


def check(instance: Instance, time_limit: float) -> Findings:
    """Compute everything anew; each guarantee within `time_limit` seconds."""
    undecided: list[str] = []
    mistakes = [
        *_mistakes_of_text(instance),
        *_mistakes_of_plan(instance),
        *_mistakes_of_guarantee(instance, time_limit, undecided),
        *_mistakes_of_lower_end(instance),
        *_mistakes_of_upper_end(instance),
    ]
    return Findings(mistakes, undecided)


def _mistakes_of_text(instance: Instance) -> Iterator[str]:
    """Compare the file with what is written of its values, which has `exact` beside them."""
    lines = values_path(instance.name).read_text(encoding="utf-8").splitlines()
    wanted = values_text(instance.name, instance.plan, instance.bracket).splitlines()
    pairs = zip_longest(lines, wanted, fillvalue="")
    yield from (f"expected the line `{ours}`, got `{line}`" for line, ours in pairs if line != ours)


def _mistakes_of_plan(instance: Instance) -> Iterator[str]:
    team, disk, plan, _ = instance.parts()
    if np.abs(plan.turns).max() > math.pi:
        yield "plan.turns: expected turns in [-π, π]"
    off = np.abs(wrap_angle(team.headings + plan.turns - plan.goal_headings))
    if off.max() > _ROUNDING:
        yield f"plan.goal_headings: evader {off.argmax()} flies elsewhere after its turn"
    time = float(capture_times(team, disk, plan.turns, plan.worst_sequence)[-1])
    yield from _unequal("plan.upper", plan.upper, time, _ROUNDING)


def _mistakes_of_guarantee(
    instance: Instance, time_limit: float, undecided: list[str]
) -> Iterator[str]:
    team, disk, plan, _ = instance.parts()
    found = guaranteed_survival(team, disk, plan.turns, time_limit=time_limit)
    above, below = 1.0 + _ROUNDING, 1.0 - _ROUNDING
    if plan.survival_time > found.upper * above:
        sequence = " ".join(map(str, found.sequence))
        yield (
            f"plan.survival_time: is {plan.survival_time!r}, but {sequence} captures everybody by "
            f"{found.upper!r}"
        )
    elif plan.upper < found.time * below:
        yield f"plan.upper: is {plan.upper!r}, but {found.time!r} is guaranteed"
    elif found.time < plan.survival_time * below:
        undecided.append(
            f"plan.survival_time: {found.time!r} was proven within {time_limit:g} s, of "
            f"{plan.survival_time!r}"
        )


def _mistakes_of_lower_end(instance: Instance) -> Iterator[str]:
    team, disk, plan, bracket = instance.parts()
    if bracket.lower_by is LowerEnd.OPEN_LOOP:
        yield from _unequal("bracket.lower", bracket.lower, plan.survival_time, 0.0)
    else:
        tree = plan_contingent(team, disk, bracket.depth)
        yield from _unequal("bracket.lower", bracket.lower, tree.with_delays.survival_time, _ASCENT)
    if bracket.lower > bracket.upper * (1.0 + _ROUNDING):
        yield f"bracket.lower: {bracket.lower!r} is above upper, {bracket.upper!r}"


def _mistakes_of_upper_end(instance: Instance) -> Iterator[str]:
    team, disk, _, bracket = instance.parts()
    off = bracket.start - disk.center
    if np.hypot(*off) > disk.radius * (1.0 + _ROUNDING):
        yield f"bracket.start: {bracket.start.tolist()} is outside the pursuer's disk"
    end = upper_end_from(team, disk, bracket.start, bracket.sequence)
    yield from _unequal("bracket.upper", bracket.upper, end.time, _ROUNDING)
    if end.by is not bracket.upper_by:
        yield f"bracket.upper_by: expected {end.by}, got {bracket.upper_by}"
    if end.sequence != bracket.sequence:
        yield f"bracket.sequence: expected {list(end.sequence)}, got {list(bracket.sequence)}"


def _unequal(name: str, stored: float, computed: float, tolerance: float) -> Iterator[str]:
    if abs(stored - computed) > tolerance * abs(computed):
        yield f"{name}: is {stored!r}, computed again {computed!r}"
