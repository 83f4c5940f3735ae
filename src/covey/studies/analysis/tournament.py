"""Every team against every pursuer: survival times relative to those of the first team."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from covey.studies.analysis.paired_ratios import (
    Comparison,
    PairedRatio,
    ratios_by_size,
    varies_alone,
)
from covey.studies.running.results import StudyResult
from covey.studies.running.tables import labels

_SIDES = ("team_size", "sensing", "evaders", "pursuer")  # in the order of the grid


def is_tournament(study: dict[str, Any]) -> bool:
    """Return whether a study has several teams, and beside them only `_SIDES` vary."""
    return varies_alone(study, "evaders", _SIDES)


def tournament(result: StudyResult) -> Comparison:
    """Return the ratios of a tournament: a group for each sensing, a column for each pursuer."""
    grid = result.study["grid"]
    base, (objective,) = labels(grid["evaders"])[0], grid["objective"]
    column, words = "survival_time", "mean survival time"
    if objective["name"] != "last-capture":
        column, words = "value", f"mean of the {objective['name']}"
    return Comparison("team", base, f"{words}, relative to {base}", list(_ratios(result, column)))


def _ratios(result: StudyResult, column: str) -> Iterator[PairedRatio]:
    grid = result.study["grid"]
    evaders, pursuers = labels(grid["evaders"]), labels(grid["pursuer"])
    shape = [len(grid[name]) for name in _SIDES]
    parts = [part[column].to_numpy() for part in result.parts()]
    values = np.concatenate([np.empty(0), *parts]).reshape(-1, *shape)
    for (s, sensing), (p, pursuer), (e, team) in product(
        enumerate(grid["sensing"]), enumerate(pursuers), enumerate(evaders)
    ):
        cell = (f"{sensing} pursuer", pursuer, team)
        own, reference = values[:, :, s, e, p], values[:, :, s, 0, p]
        yield from ratios_by_size(cell, grid["team_size"], own, reference)
