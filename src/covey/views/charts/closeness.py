"""Chart: how close strategies come to the value of the game, by the speeds of two evaders."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.views.kit import style
from covey.views.kit.layout import panels_in_a_row, width_of_panels
from covey.views.kit.page import sheet_of
from covey.views.kit.style import styled

_SIDE = 2.0
_HEADROOM = 0.62
_COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", style.INK, style.FAINT)
_MARKS = ("o", "s", "^", "D", "v", "P", "X", "*")
_SPREAD = 0.6


class Closeness(NamedTuple):
    """Survival time over the value of the game: its mean and its least over all starts."""

    mean: float
    least: float


@styled
def draw_closeness(
    panels: Mapping[str, Mapping[str, Mapping[str, Closeness]]],
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float | None = None,
) -> Figure:
    """Draw survival time over the value: a mark at the mean, a line down to the least.

    Parameters
    ----------
    panels
        For each panel, by its title, each strategy's closeness by the speeds.
    ax
        Axes in whose place the panels are drawn. Default: a new figure.
    title
        Above all panels. Default: none.
    width
        Of a new figure, inches. Default: two columns of a paper, 7, for two panels.

    Returns
    -------
    matplotlib.figure.Figure
        Panels side by side on one scale.

    Examples
    --------
    >>> from covey import views
    >>> near = views.Closeness(mean=0.996, least=0.935)
    >>> figure = views.draw_closeness({"random pairs": {"open-loop": {"0.25 / 0.25": near}}})
    """
    least = min(
        each.least
        for strategies in panels.values()
        for row in strategies.values()
        for each in row.values()
    )
    sheet = sheet_of(ax, title, width or width_of_panels(len(panels)))
    page, all_axes = panels_in_a_row(list(panels), _SIDE, _HEADROOM, sheet)
    for axes, strategies in zip(all_axes, panels.values(), strict=True):
        _draw_panel(axes, strategies)
        axes.set_ylim(1.0 - 1.15 * (1.0 - least), 1.0 + 0.08 * (1.0 - least))
    first = all_axes[0]
    first.set_ylabel("survival time over the value")
    page.legend(*first.get_legend_handles_labels(), loc="upper center", ncols=4)
    return page.figure


def _draw_panel(axes: Axes, strategies: Mapping[str, Mapping[str, Closeness]]) -> None:
    offsets = _SPREAD * ((np.arange(len(strategies)) + 0.5) / len(strategies) - 0.5)
    for k, (name, row) in enumerate(strategies.items()):
        x = np.arange(len(row)) + offsets[k]
        means, least = np.array(list(row.values())).T
        color = _COLORS[k % len(_COLORS)]
        axes.vlines(x, least, means, color=color, linewidth=style.THIN_LINE)
        axes.plot(
            x,
            means,
            color=color,
            linestyle="none",
            marker=_MARKS[k % len(_MARKS)],
            markersize=0.8 * style.EVADER_SIZE,
            markeredgewidth=0.0,
            label=name.replace("-", " "),
            gid=name,
        )
        axes.set_xticks(range(len(row)), list(row))
    axes.axhline(1.0, **style.GUIDE)
    axes.set_xlabel("speeds of the two, relative to the pursuer's", labelpad=2)
    axes.spines[["top", "right"]].set_visible(False)
