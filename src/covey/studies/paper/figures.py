"""The numbers behind Figs. 4 and 5 of the paper, from the studies fig4 and fig5."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from covey.model.validation import Floats, InputError
from covey.studies.running.results import StudyResult
from covey.studies.statistics import Estimate

HIDDEN, VISIBLE = "hidden", "visible"


class Gains(NamedTuple):
    """Mean survival times by turning rate, for one sensing."""

    turn_rates: list[float]  # ascending
    ratios: dict[int, list[Estimate]]  # by team size: means over those of other cases
    survival: dict[int, list[Estimate]]  # by team size: the means themselves


def survival_ratios(result: StudyResult) -> dict[int, Floats]:
    """Return, for each team size, the ratio hidden over visible of every start (Fig. 4).

    Starts of which a game was stopped are left out.
    """
    times = {size: both_times(result, size) for size in result.study["grid"]["team_size"]}
    return {size: hidden / visible for size, (hidden, visible) in times.items()}


def both_times(result: StudyResult, size: int, starts: int | None = None) -> tuple[Floats, Floats]:
    """Return hidden and visible survival times of a team size, of the first `starts`.

    Starts of which a game was stopped are left out.
    """
    times = _by_case(result, "survival_time")[:starts]
    hidden, visible = (
        times[:, result.case_number(team_size=size, sensing=word)] for word in (HIDDEN, VISIBLE)
    )
    ended = np.isfinite(hidden) & np.isfinite(visible)
    return hidden[ended], visible[ended]


def guarantee_ratios(result: StudyResult) -> dict[int, Floats]:
    """Return, for each team size, visible survival over the guarantee of the first plan."""
    ratios = _by_case(result, "survival_time") / _by_case(result, "guarantee")
    return {
        size: ratios[:, result.case_number(team_size=size, sensing=VISIBLE)]
        for size in result.study["grid"]["team_size"]
    }


def turn_rate_gains(result: StudyResult) -> dict[str, Gains]:
    """Return, for each sensing, the mean survival times by turning rate and team size (Fig. 5)."""
    grid = result.study["grid"]
    if grid["turn_rate"] == [None]:
        raise InputError("study: expected turn rates to compare, got one of turning radii")
    found = {}
    for word in grid["sensing"]:
        cases = _cases(result, sensing=word)
        found[word] = _gains(
            result, cases, {size: [row[0]] * len(row) for size, row in cases.items()}
        )
    return found


def answer_gains(result: StudyResult) -> Gains:
    """Return what the second team of a study gains over the first, at each turning rate."""
    first, second = result.study["grid"]["evaders"]
    return _gains(result, _cases(result, evaders=second), _cases(result, evaders=first))


def raised(gains: Gains, answers: Gains) -> Gains:
    """Return the gains of teams that answer captures, from the paper's and what answers gain.

    The errors are those of independent estimates.
    """
    ratios = {
        size: [_product(*pair) for pair in zip(gains.ratios[size], row, strict=True)]
        for size, row in answers.ratios.items()
    }
    return Gains(gains.turn_rates, ratios, answers.survival)


def _product(one: Estimate, other: Estimate) -> Estimate:
    value = one.value * other.value
    return Estimate(value, value * math.hypot(one.error / one.value, other.error / other.value))


def _cases(result: StudyResult, **fields: Any) -> dict[int, list[int]]:
    """Return the numbers of the cases with these fields, by team size, by ascending turn rate."""
    grid = result.study["grid"]
    return {
        size: [
            result.case_number(team_size=size, turn_rate=rate, **fields)
            for rate in sorted(grid["turn_rate"])
        ]
        for size in grid["team_size"]
    }


def _gains(
    result: StudyResult, cases: Mapping[int, list[int]], bases: Mapping[int, list[int]]
) -> Gains:
    """Return the means of cases, and their ratios to those of other cases."""
    moments = result.moments
    ratios = {
        size: [moments.ratio(*pair) for pair in zip(row, bases[size], strict=True)]
        for size, row in cases.items()
    }
    means = {size: [moments.average(case) for case in row] for size, row in cases.items()}
    return Gains(sorted(result.study["grid"]["turn_rate"]), ratios, means)


def _by_case(result: StudyResult, column: str) -> Floats:
    """Return a column of the table of games, (starts, cases)."""
    parts = [part[column].to_numpy() for part in result.parts()]
    return np.concatenate(parts).reshape(-1, len(result.cases))
