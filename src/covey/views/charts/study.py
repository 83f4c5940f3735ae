"""A picture of any study: the paper's kinds, a comparison, growth, or the means of all cases."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import InputError
from covey.model.units import titled, with_unit
from covey.studies import (
    CaseSummary,
    Comparison,
    Gains,
    StudyResult,
    comparison,
    summary,
    survival_ratios,
    turn_rate_gains,
)
from covey.studies.statistics import Estimate
from covey.views.charts.comparison import Ratio, draw_comparison
from covey.views.charts.gains import Curve, draw_gains
from covey.views.charts.growth import draw_growth
from covey.views.charts.ratios import draw_ratios

_MANY_SIZES = 5  # from so many on a curve shows the growth better than marks beside each other
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
    Fig. 5. One of at least five team sizes, and at most one other thing that varies, is drawn as
    curves over the size. Any other is drawn as the mean survival time in each case.

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
    label = _MEANS.format(time=titled("survival time", result.units.time))
    if len(result.study["grid"]["team_size"]) >= _MANY_SIZES and len(varying) <= 2:
        return draw_growth(*_growth(result), label, **sheet)
    if "turn_rate" in varying and varying <= {"team_size", "sensing", "turn_rate"}:
        return _draw_gains(result, sheet)
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


def _growth(result: StudyResult) -> tuple[list[int], dict[str, list[Estimate]]]:
    """Return the team sizes, and the means of each curve over them."""
    curves: dict[str, dict[int, Estimate]] = {}
    for line in summary(result):
        case = result.cases[line.case]
        name = _settings_text(result, line, {"team_size"})
        curves.setdefault(name, {})[case["team_size"]] = line.survival
    sizes = sorted(result.study["grid"]["team_size"])
    return sizes, {name: [means[size] for size in sizes] for name, means in curves.items()}


def _means(result: StudyResult) -> Iterator[Ratio]:
    """Return the mean of each case: a row for each sensing, a strip for the other settings."""
    for line in summary(result):
        case = result.cases[line.case]
        strip = _settings_text(result, line, {"team_size", "sensing"})
        row = f"{case['sensing']} pursuer"
        yield Ratio(row, "", strip or "all games", case["team_size"], *line.survival)


def _as_printed(text: str) -> str:
    """Write π and ∞ as a person does, who types pi and inf."""
    return re.sub(r"\bpi\b", "π", re.sub(r"\binf\b", "∞", text))


def _settings_text(result: StudyResult, line: CaseSummary, left_out: set[str]) -> str:
    """Return the settings in which a case differs from others, as a person reads them."""
    texts = {
        name: with_unit(_as_printed(result.text_of(name, value)), result.unit_of(name))
        for name, value in line.settings.items()
        if name not in left_out
    }
    return ", ".join(
        text if name in ("evaders", "pursuer", "objective") else f"{name} {text}"
        for name, text in texts.items()
    ).replace("_", " ")
