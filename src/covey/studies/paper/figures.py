"""The numbers behind Figs. 4 and 5 of the paper, from the studies fig4 and fig5."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from covey.model.validation import Floats, InputError
from covey.studies.running.results import StudyResult
from covey.studies.statistics import Estimate

HIDDEN, VISIBLE = "hidden", "visible"


class Gains(NamedTuple):
    """Mean survival times by turning rate, for one sensing."""

    turn_rates: list[float]  # ascending
    ratios: dict[int, list[Estimate]]  # by team size: means over the mean at the lowest rate
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
    return {word: _gains(result, word, sorted(grid["turn_rate"])) for word in grid["sensing"]}


def _gains(result: StudyResult, sensing: str, rates: list[float]) -> Gains:
    moments, ratios, means = result.moments, {}, {}
    for size in result.study["grid"]["team_size"]:
        cases = [
            result.case_number(team_size=size, turn_rate=rate, sensing=sensing) for rate in rates
        ]
        ratios[size] = [moments.ratio(case, cases[0]) for case in cases]
        means[size] = [moments.average(case) for case in cases]
    return Gains(rates, ratios, means)


def _by_case(result: StudyResult, column: str) -> Floats:
    """Return a column of the table of games, (starts, cases)."""
    parts = [part[column].to_numpy() for part in result.parts()]
    return np.concatenate(parts).reshape(-1, len(result.cases))
