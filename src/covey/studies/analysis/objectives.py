"""Teams with different objectives from the same starts: times of the first and last capture."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from covey.model.validation import Floats
from covey.studies.analysis.paired_ratios import (
    Comparison,
    PairedRatio,
    ratios_by_size,
    varies_alone,
)
from covey.studies.running.results import StudyResult
from covey.studies.running.tables import labels

_SIDES = ("team_size", "sensing", "objective", "pursuer")  # in the order of the grid
MEASURES = ("first capture", "mean survival", "last capture")


def compares_objectives(study: dict[str, Any]) -> bool:
    """Return whether a study has several objectives, and beside them only `_SIDES` vary."""
    return varies_alone(study, "objective", _SIDES)


def objectives(result: StudyResult) -> Comparison:
    """Return a group for each sensing and pursuer, a column for each of `MEASURES`."""
    base = _names(result.study["grid"]["objective"])[0]
    label = f"mean, relative to games about the {base}"
    return Comparison("about the", base, label, list(_ratios(result)))


def _names(given: list[dict[str, Any]]) -> list[str]:
    """Return a few words for each objective, or its description where words would not be unique."""
    names = [_name(each) for each in given]
    return names if len(set(names)) == len(names) else labels(given)


def _name(objective: dict[str, Any]) -> str:
    default = "total" if objective["name"] == "total-survival" else "last"
    measure = {"last": "last capture", "total": "sum"}[objective.get("measure", default)]
    if objective["name"] != "expected-survival":
        return measure
    drawn = f" of {len(objective['sequences'])} sequences" if "sequences" in objective else ""
    return f"expected {measure}{drawn}"


def _ratios(result: StudyResult) -> Iterator[PairedRatio]:
    grid = result.study["grid"]
    names, pursuers = _names(grid["objective"]), labels(grid["pursuer"])
    times = _times(result, [len(grid[name]) for name in _SIDES])
    for (s, sensing), (p, pursuer), (m, measure), (o, name) in product(
        enumerate(grid["sensing"]), enumerate(pursuers), enumerate(MEASURES), enumerate(names)
    ):
        cell = (f"{sensing} pursuer, {pursuer}", measure, name)
        own, reference = times[:, :, s, o, p, m], times[:, :, s, 0, p, m]
        yield from ratios_by_size(cell, grid["team_size"], own, reference)


def _times(result: StudyResult, shape: list[int]) -> Floats:
    """Return `MEASURES` of all games, (starts, *shape, 3); inf where a game was stopped."""
    size = max(result.study["grid"]["team_size"])
    games = [np.empty((0, len(MEASURES)))]
    for part in result.parts():
        last = part["survival_time"].to_numpy()
        times = np.array([part[f"capture_time_{k}"].to_numpy() for k in range(size)], np.float64)
        mean = np.nanmean(times, axis=0)  # the columns of missing evaders are nan
        mean[np.isinf(last)] = np.inf
        games.append(np.column_stack([times[0], mean, last]))
    return np.concatenate(games).reshape(-1, *shape, len(MEASURES))
