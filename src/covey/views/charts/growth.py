"""Chart: mean survival time over the size of the team, a curve for each case."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from covey.studies.statistics import Estimate
from covey.views.kit import style
from covey.views.kit.page import new_page, sheet_of
from covey.views.kit.style import styled

_LEFT, _BOTTOM, _SIDE, _RIGHT, _ABOVE = 0.5, 0.4, 2.2, 0.1, 0.1


@styled
def draw_growth(
    sizes: Sequence[int],
    curves: Mapping[str, Sequence[Estimate]],
    label: str,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = style.COLUMN_WIDTH,
) -> Figure:
    """Draw how the mean survival time grows with the size of the team.

    Parameters
    ----------
    sizes
        (K,) numbers of evaders, in ascending order.
    curves
        By its name, the means (K,) of each curve with their intervals.
    label
        Of the times.
    ax
        Axes in whose place the chart is drawn. Default: a new figure.
    title
        Above the chart. Default: none.
    width
        Of a new figure, inches.

    Returns
    -------
    matplotlib.figure.Figure
    """
    sheet = sheet_of(ax, title, width)
    page = new_page(sheet, _BOTTOM + _SIDE + _ABOVE)
    axes = page.panel(_LEFT, _BOTTOM, sheet.width - _LEFT - _RIGHT, _SIDE)
    for k, (name, estimates) in enumerate(curves.items()):
        shown = style.team_size_series(k, 0, len(curves)) | {"label": name}
        axes.errorbar(
            sizes,
            [each.value for each in estimates],
            yerr=[each.error for each in estimates],
            markersize=0.8 * style.EVADER_SIZE,
            linewidth=style.EVADER_LINE,
            gid=name,
            **shown,
        )
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    axes.xaxis.set_major_locator(MaxNLocator("auto", steps=[1, 2, 5, 10], integer=True))
    axes.set_xlabel("evaders $N$", labelpad=2)
    axes.set_ylabel(label)
    axes.spines[["top", "right"]].set_visible(False)
    if len(curves) > 1:
        axes.legend(loc="lower right")
    return page.figure
