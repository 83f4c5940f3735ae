"""Chart: histograms of ratios, a panel for each team size (Fig. 4 of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from covey.model import InputError
from covey.model.units import counted
from covey.model.validation import Floats, Ints
from covey.views.kit import style
from covey.views.kit.page import fit, new_page, sheet_of
from covey.views.kit.style import styled

_BIN = 0.01
_PANEL = 1.05
_HEADROOM = 1.2
"""Of a panel over its highest bar, which leaves room for a text."""


@styled
def draw_ratios(
    ratios: Mapping[int, npt.ArrayLike],
    *,
    beside: Mapping[int, npt.ArrayLike] | None = None,
    panels: str = "ab",
    ax: Axes | None = None,
    title: str | None = None,
    width: float = style.COLUMN_WIDTH,
) -> Figure:
    """Draw histograms of the ratio of survival times, hidden over visible.

    Parameters
    ----------
    ratios
        For each team size, the ratio of every start.
    beside
        For some team sizes, ratios with the assured pursuer: a line of the same height for the
        same share of its starts.
    panels
        Letters of the panels, one for each team size.
    ax
        Axes in whose place the panels are drawn. Default: a new figure.
    title
        Above all panels. Default: none.
    width
        Of a new figure, inches. Default: one column of a paper.

    Returns
    -------
    matplotlib.figure.Figure
        Bins are 0.01 wide; 1 is the middle of a bin.

    Raises
    ------
    InputError
        If there is nothing to draw.

    Examples
    --------
    >>> from covey import views
    >>> figure = views.draw_ratios({3: [1.0, 0.99, 1.0], 5: [0.97, 1.0, 0.95]})
    """
    samples = {size: np.asarray(values, dtype=np.float64) for size, values in ratios.items()}
    if not samples or any(len(values) == 0 for values in samples.values()):
        raise InputError("ratios: expected at least one ratio for every team size")
    others = {size: np.asarray(values, np.float64) for size, values in (beside or {}).items()}
    edges = _edges(np.concatenate([*samples.values(), *others.values()]))
    count, left, bottom, gap = len(samples), 0.44, 0.36, 0.30
    height = bottom + count * _PANEL + (count - 1) * gap + 0.22
    page = new_page(sheet_of(ax, title, width), height)
    for row, (size, values) in enumerate(samples.items()):
        up = height - 0.22 - (row + 1) * _PANEL - row * gap
        axes = page.panel(left, up, page.width - left - 0.08, _PANEL)
        counts = _draw_panel(axes, values, edges)
        tops = counts.astype(np.float64)
        if size in others:
            tops = np.maximum(tops, _draw_line(axes, others[size], edges, len(values)))
        axes.set_ylim(0.0, _HEADROOM * tops.max())
        _name_bar_at_one(axes, counts, tops, edges)
        letter = panels[row : row + 1]
        axes.set_title(
            f"({letter})  $N = {size}$, {counted(len(values), 'start')}", loc="left", pad=3
        )
        if row < count - 1:
            axes.tick_params(labelbottom=False)
    name = axes.set_xlabel("survival time, hidden / visible", labelpad=2)
    fit(name, page.width - left - 0.08)
    return page.figure


def _edges(values: Floats) -> Floats:
    """Edges of bins that hold all values; 1 is the middle of a bin."""
    low = math.floor((min(values.min(), 0.9) - 1.0) / _BIN + 0.5)
    high = math.ceil((max(values.max(), 1.0) - 1.0) / _BIN - 0.5)
    return 1.0 + _BIN * (np.arange(low, high + 2) - 0.5)


def _draw_panel(axes: Axes, values: Floats, edges: Floats) -> Ints:
    """Draw a histogram and return the counts of its bins."""
    counts, _ = np.histogram(values, edges)
    middle = 0.5 * (edges[1:] + edges[:-1])
    at_one = _is_at_one(edges)
    for chosen, color in ((~at_one, style.EVADER), (at_one, style.CAPTURED)):
        axes.bar(
            middle[chosen],
            counts[chosen],
            0.9 * _BIN,
            color=color,
            linewidth=0.0,
            gid="bars" if color == style.EVADER else "bar at one",
        )
    axes.axvline(0.9, **style.GUIDE)
    axes.set_xlim(edges[0], edges[-1])
    axes.set_ylabel("starts", labelpad=3)
    axes.yaxis.set_major_locator(MaxNLocator("auto", steps=[1, 2, 2.5, 5, 10], integer=True))
    axes.spines[["top", "right"]].set_visible(False)
    return counts


def _is_at_one(edges: Floats) -> npt.NDArray[np.bool_]:
    """Tell which bin has 1 in its middle."""
    return np.abs(0.5 * (edges[1:] + edges[:-1]) - 1.0) < 0.5 * _BIN


def _name_bar_at_one(axes: Axes, counts: Ints, tops: Floats, edges: Floats) -> None:
    """Write the count of the bin at 1 above everything that is drawn below the text."""
    k = int(np.argmax(_is_at_one(edges)))
    text = axes.annotate(
        f"$1 \\pm 0.005$: {counts[k]}",
        (edges[k + 1], 0.0),
        xytext=(0.0, 2.0),
        textcoords="offset points",
        ha="right",
        va="bottom",
        color=style.CAPTURED,
        fontsize=style.SMALL_TEXT_SIZE,
    )
    box = text.get_window_extent().transformed(axes.transData.inverted())
    below = (edges[1:] > box.x0) & (edges[:-1] < box.x1)
    text.xy = (float(edges[k + 1]), float(tops[below].max()))


def _draw_line(axes: Axes, values: Floats, edges: Floats, starts: int) -> Floats:
    """Draw the histogram of the assured pursuer as a line, scaled to a number of starts.

    Returns the heights of its bins.
    """
    counts, _ = np.histogram(values, edges)
    heights: Floats = counts * starts / len(values)
    axes.stairs(heights, edges, color=style.PURSUER, linewidth=1.0, gid="assured")
    axes.set_title(
        f"line: assured, {counted(len(values), 'start')}",
        loc="right",
        pad=3,
        color=style.PURSUER,
        fontsize=style.SMALL_TEXT_SIZE,
    )
    return heights
