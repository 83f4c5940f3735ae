"""A study in a table: one line a case, with confidence intervals."""

from __future__ import annotations

from itertools import product
from typing import Any, NamedTuple

from covey.studies.design.study import GRID
from covey.studies.running.results import StudyResult
from covey.studies.running.tables import described_text
from covey.studies.statistics import Estimate


class Line(NamedTuple):
    """What is known of one case."""

    case: int
    settings: dict[str, Any]  # those that differ from case to case
    starts: int
    stopped: int  # games that ended at their time limit, with evaders alive
    guarantee: float  # mean
    survival: Estimate  # mean
    relative: Estimate  # mean over the mean of the first case of the same team size
    value: Estimate | None  # mean of what came of the objective, where that isn't the last capture


def summary(result: StudyResult) -> list[Line]:
    """Return the lines of a study; averages are over starts whose games all came to an end."""
    moments, cases = result.moments, _cases(result)
    varying = [name for name in GRID if len({str(case[name]) for case in cases}) > 1]
    others = any(each["name"] != "last-capture" for each in result.study["grid"]["objective"])
    lines, bases = [], dict[int, int]()
    for k, case in enumerate(cases):
        base = bases.setdefault(case["team_size"], k)
        lines.append(
            Line(
                case=k,
                settings={name: case[name] for name in varying},
                starts=moments.ended,
                stopped=int(moments.stopped[k]),
                guarantee=float(moments.guarantee[k]),
                survival=moments.average(k),
                relative=moments.ratio(k, base),
                value=result.values.average(k) if others else None,
            )
        )
    return lines


def _cases(result: StudyResult) -> list[dict[str, Any]]:
    grid = result.study["grid"]
    values = [[_plain(value) for value in grid[name]] for name in GRID]
    return [dict(zip(GRID, combination, strict=True)) for combination in product(*values)]


def _plain(value: Any) -> Any:
    return described_text(value) if isinstance(value, dict) else value
