"""The numbers behind Figs. 4 and 5 of the paper, from the studies fig4 and fig5."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from covey.model.validation import Floats
from covey.studies.running.results import StudyResult
from covey.studies.statistics import Estimate

HIDDEN, VISIBLE = "hidden", "visible"


class Gains(NamedTuple):
    """Means over the mean at the lowest turning rate, for one sensing."""

    turn_rates: list[float]
    ratios: dict[int, list[Estimate]]  # by team size
    survival: dict[int, list[Estimate]]  # the means themselves


def survival_ratios(result: StudyResult) -> dict[int, Floats]:
    """Return, for each team size, the ratio hidden over visible of every start (Fig. 4).

    Starts of which a game didn't end are left out.
    """
    sizes: list[int] = result.study["grid"]["team_size"]
    sensing: list[str] = result.study["grid"]["sensing"]
    times = np.concatenate(
        [part["survival_time"].to_numpy().reshape(-1, len(sizes), 2) for part in result.parts()]
    )
    hidden, visible = sensing.index(HIDDEN), sensing.index(VISIBLE)
    ratios = {}
    for k, size in enumerate(sizes):
        ended = np.isfinite(times[:, k]).all(axis=1)
        ratios[size] = times[ended, k, hidden] / times[ended, k, visible]
    return ratios


def guarantee_ratios(result: StudyResult) -> dict[int, Floats]:
    """Return, for each team size, visible survival over the guarantee of the first plan."""
    sizes: list[int] = result.study["grid"]["team_size"]
    visible = result.study["grid"]["sensing"].index(VISIBLE)
    times, guarantees = (
        np.concatenate(
            [part[name].to_numpy().reshape(-1, len(sizes), 2)[:, :, visible] for part in parts]
        )
        for name in ("survival_time", "guarantee")
        for parts in [list(result.parts())]
    )
    return {size: times[:, k] / guarantees[:, k] for k, size in enumerate(sizes)}


def turn_rate_gains(result: StudyResult) -> dict[str, Gains]:
    """Return, for each sensing, what turning rates bring to each team size (Fig. 5)."""
    grid, moments = result.study["grid"], result.moments
    sizes, rates, sensing = grid["team_size"], grid["turn_rate"], grid["sensing"]

    def case(i: int, j: int, k: int) -> int:
        return (i * len(rates) + j) * len(sensing) + k

    order = [int(j) for j in np.argsort(rates)]
    return {
        word: Gains(
            [rates[j] for j in order],
            {
                size: [moments.ratio(case(i, j, k), case(i, order[0], k)) for j in order]
                for i, size in enumerate(sizes)
            },
            {size: [moments.average(case(i, j, k)) for j in order] for i, size in enumerate(sizes)},
        )
        for k, word in enumerate(sensing)
    }
