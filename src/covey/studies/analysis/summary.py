"""A study in a table: one line a case, with confidence intervals."""

from __future__ import annotations

from typing import Any, NamedTuple

from covey.studies.design.case import GRID
from covey.studies.running.results import StudyResult
from covey.studies.running.tables import described_text
from covey.studies.statistics import Estimate


class CaseSummary(NamedTuple):
    """The results of one case."""

    case: int
    settings: dict[str, Any]  # those that differ between the cases of the study
    starts: int
    stopped: int  # games that ended at their time limit, with evaders alive
    guarantee: float  # mean
    survival: Estimate  # mean
    relative: Estimate  # mean over the mean of the first case of the same team size
    value: Estimate | None  # mean of the objective; None if all games are about the last capture


def summary(result: StudyResult) -> list[CaseSummary]:
    """Return a line for each case. Means are over the starts whose games all ended.

    Examples
    --------
    >>> import tempfile
    >>> import covey
    >>> from covey import studies
    >>> study = covey.Study(starts=3, team_size=2, update_time=0.1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     lines = studies.summary(covey.run_study(study, folder, workers=1))
    ...
    >>> [line.settings["sensing"] for line in lines]
    ['visible', 'hidden']
    """
    cases = [{name: _plain(value) for name, value in case.items()} for case in result.cases]
    moments, grid = result.moments, result.study["grid"]
    varying = [name for name in GRID if len({str(case[name]) for case in cases}) > 1]
    valued = any(each["name"] != "last-capture" for each in grid["objective"])
    lines, bases = [], dict[int, int]()
    for k, case in enumerate(cases):
        base = bases.setdefault(case["team_size"], k)
        lines.append(
            CaseSummary(
                case=k,
                settings={name: case[name] for name in varying},
                starts=moments.ended,
                stopped=int(moments.stopped[k]),
                guarantee=float(moments.guarantee[k]),
                survival=moments.average(k),
                relative=moments.ratio(k, base),
                value=result.values.average(k) if valued else None,
            )
        )
    return lines


def _plain(value: Any) -> Any:
    return described_text(value) if isinstance(value, dict) else value
