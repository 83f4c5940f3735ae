"""A picture of any study: the paper's kinds, a comparison, or the means of all cases."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import InputError
from covey.model.units import titled, with_unit
from covey.studies import (
    Comparison,
    Gains,
    StudyResult,
    comparison,
    summary,
    survival_ratios,
    turn_rate_gains,
)
from covey.views.charts.comparison import Ratio, draw_comparison
from covey.views.charts.gains import Curve, draw_gains
from covey.views.charts.ratios import draw_ratios

_MEANS = "mean {time}, ± 95 % confidence"


def draw_study(
    result: StudyResult,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float | None = None,
) -> Figure:
    """Draw the results of a study.

    A study of several teams, or objectives, is drawn as ratios of means. One in which beside team
    sizes only sensing varies is drawn as Fig. 4 of the paper; one in which turn rates vary too, as
    Fig. 5. Any other is drawn as the mean survival time in each case.

    Parameters
    ----------
    result
        What `covey.run_study` or `covey.load_study` returned.
    ax
        Axes in whose place the panels are drawn. Default: a new figure.
    title
        Above all panels. Default: none.
    width
        Of a new figure, inches. Default: one or two columns of a paper, by the kind of study.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If no game, or too few, came to their end.

    Examples
    --------
    >>> import tempfile
    >>> import covey
    >>> from covey import views
    >>> teams = ["open-loop", "straight-away"]
    >>> study = covey.Study(starts=3, team_size=2, update_time=0.1, evaders=teams)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     figure = views.draw_study(covey.run_study(study, folder, workers=1))
    ...
    """
    sheet: dict[str, Any] = {"ax": ax, "title": title}
    if width is not None:
        sheet["width"] = width
    compared = comparison(result)
    if compared is not None:
        return draw_comparison(_compared(compared, result), compared.label, **sheet)
    if not result.moments.ended:
        raise InputError(f"{result.folder}: expected games that came to their end, got none")
    varying = {name for name, values in result.study["grid"].items() if len(values) > 1}
    if varying - {"team_size"} == {"sensing"}:
        return draw_ratios(survival_ratios(result), **sheet)
    if "turn_rate" in varying and varying <= {"team_size", "sensing", "turn_rate"}:
        return _draw_gains(result, sheet)
    label = _MEANS.format(time=titled("survival time", result.units.time))
    return draw_comparison(list(_means(result)), label, reference=None, **sheet)


def _compared(compared: Comparison, result: StudyResult) -> list[Ratio]:
    """Return the ratios of single team sizes to the reference, without its own."""
    ratios = [
        Ratio(each.group, each.column, each.row, each.team_size, *each.relative)
        for each in compared.ratios
        if each.team_size is not None and each.row != compared.base and each.starts > 1
    ]
    if not ratios:
        raise InputError(
            f"{result.folder}: expected games from at least two starts that came to their end"
        )
    return ratios


def _draw_gains(result: StudyResult, sheet: dict[str, Any]) -> Figure:
    gains = turn_rate_gains(result)
    panels = {f"{word} pursuer": curves_of(each) for word, each in gains.items()}
    return draw_gains(next(iter(gains.values())).turn_rates, panels, **sheet)


def curves_of(gains: Gains) -> dict[int, Curve]:
    """Return the curve of each team size, as `draw_gains` takes them."""
    return {
        size: Curve([each.value for each in row], [each.error for each in row])
        for size, row in gains.ratios.items()
    }


def _means(result: StudyResult) -> Iterator[Ratio]:
    """Return the mean of each case: a row for each sensing, a strip for the other settings."""
    for line in summary(result):
        case = result.cases[line.case]
        others = {
            name: with_unit(result.text_of(name, value), result.unit_of(name))
            for name, value in line.settings.items()
            if name not in ("team_size", "sensing")
        }
        strip = ", ".join(
            text if name in ("evaders", "pursuer", "objective") else f"{name} {text}"
            for name, text in others.items()
        ).replace("_", " ")
        row = f"{case['sensing']} pursuer"
        yield Ratio(row, "", strip or "all games", case["team_size"], *line.survival)
