"""Games about different things from the same starts: what each objective brings, and costs."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from covey.model.validation import Floats
from covey.studies.analysis.scores import Comparison, Score, labels, scores_by_size, varies_alone
from covey.studies.running.results import StudyResult

_SIDES = ("team_size", "sensing", "objective", "pursuer")
MEASURES = ("first capture", "mean survival", "last capture")


def compares_objectives(study: dict[str, Any]) -> bool:
    """Return whether games are about several things, and beside them only `_SIDES` vary."""
    return varies_alone(study, "objective", _SIDES)


def objectives(result: StudyResult) -> Comparison:
    """Return a group for each sensing and pursuer, a column for each of `MEASURES`."""
    base = _names(result.study["grid"]["objective"])[0]
    label = f"mean, relative to games about the {base}"
    return Comparison("about the", base, label, list(_scores(result)))


def _names(given: list[dict[str, Any]]) -> list[str]:
    """Return what games are about in a few words, if that tells them apart."""
    words = {"last": "last capture", "total": "sum"}
    names = []
    for each in given:
        measure = words[
            each.get("measure", "total" if each["name"] == "total-survival" else "last")
        ]
        expected = each["name"] == "expected-survival"
        drawn = f" of {len(each['sequences'])} sequences" if "sequences" in each else ""
        names.append(f"expected {measure}{drawn}" if expected else measure)
    return names if len(set(names)) == len(names) else labels(given)


def _scores(result: StudyResult) -> Iterator[Score]:
    grid = result.study["grid"]
    names, pursuers = _names(grid["objective"]), labels(grid["pursuer"])
    measured = _measured(result, [len(grid[name]) for name in _SIDES])
    for (s, sensing), (p, pursuer), (m, measure), (o, name) in product(
        enumerate(grid["sensing"]), enumerate(pursuers), enumerate(MEASURES), enumerate(names)
    ):
        place = (f"{sensing} pursuer, {pursuer}", measure, name)
        own, first = measured[:, :, s, o, p, m], measured[:, :, s, 0, p, m]
        yield from scores_by_size(place, grid["team_size"], own, first)


def _measured(result: StudyResult, shape: list[int]) -> Floats:
    """Return (starts, *shape, measures) of all games; inf where one was stopped."""
    size = max(result.study["grid"]["team_size"])
    games = [np.empty((0, len(MEASURES)))]
    for part in result.parts():
        last = part["survival_time"].to_numpy()
        times = np.array([part[f"capture_time_{k}"].to_numpy() for k in range(size)], np.float64)
        mean = np.nanmean(times, axis=0)  # smaller teams have no times of the others
        mean[np.isinf(last)] = np.inf
        games.append(np.column_stack([times[0], mean, last]))
    return np.concatenate(games).reshape(-1, *shape, len(MEASURES))
