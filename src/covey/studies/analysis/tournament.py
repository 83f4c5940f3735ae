"""Every team against every pursuer: what comes of each game, relative to the first team."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from covey.studies.analysis.scores import Comparison, Score, labels, scores_by_size, varies_alone
from covey.studies.running.results import StudyResult

_SIDES = ("team_size", "sensing", "evaders", "pursuer")


def is_tournament(study: dict[str, Any]) -> bool:
    """Return whether several teams of a study meet pursuers, and nothing else varies but size."""
    return varies_alone(study, "evaders", _SIDES)


def tournament(result: StudyResult) -> Comparison:
    """Return the scores of a tournament: a group for each sensing, a column for each pursuer."""
    grid = result.study["grid"]
    base, (objective,) = labels(grid["evaders"])[0], grid["objective"]
    column, words = "survival_time", "mean survival time"
    if objective["name"] != "last-capture":
        column, words = "value", f"mean of the {objective['name']}"
    return Comparison("team", base, f"{words}, relative to {base}", list(_scores(result, column)))


def _scores(result: StudyResult, column: str) -> Iterator[Score]:
    grid = result.study["grid"]
    evaders, pursuers = labels(grid["evaders"]), labels(grid["pursuer"])
    shape = [len(grid[name]) for name in _SIDES]
    parts = [part[column].to_numpy() for part in result.parts()]
    times = np.concatenate([np.empty(0), *parts]).reshape(-1, *shape)
    for (s, sensing), (p, pursuer), (e, team) in product(
        enumerate(grid["sensing"]), enumerate(pursuers), enumerate(evaders)
    ):
        place = (f"{sensing} pursuer", pursuer, team)
        own, first = times[:, :, s, e, p], times[:, :, s, 0, p]
        yield from scores_by_size(place, grid["team_size"], own, first)
