"""Chart: histograms of ratios, a panel for each team size (Fig. 4 of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from covey.model import InputError
from covey.model.units import counted
from covey.model.validation import Floats
from covey.views.kit import style
from covey.views.kit.layout import add_axes, new_figure
from covey.views.kit.style import styled

_BIN = 0.01
_PANEL = 1.05


@styled
def draw_ratios(
    ratios: Mapping[int, npt.ArrayLike],
    *,
    beside: Mapping[int, npt.ArrayLike] | None = None,
    panels: str = "ab",
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

    Returns
    -------
    matplotlib.figure.Figure
        One column of a paper wide. Bins are 0.01 wide; 1 is the middle of a bin.

    Raises
    ------
    InputError
        If there is nothing to draw.
    """
    samples = {size: np.asarray(values, dtype=np.float64) for size, values in ratios.items()}
    if not samples or any(len(values) == 0 for values in samples.values()):
        raise InputError("ratios: expected at least one ratio for every team size")
    others = {size: np.asarray(values, np.float64) for size, values in (beside or {}).items()}
    edges = _edges(np.concatenate([*samples.values(), *others.values()]))
    count, left, bottom, gap = len(samples), 0.44, 0.36, 0.30
    height = bottom + count * _PANEL + (count - 1) * gap + 0.22
    figure = new_figure(style.COLUMN_WIDTH, height)
    for row, (size, values) in enumerate(samples.items()):
        up = height - 0.22 - (row + 1) * _PANEL - row * gap
        axes = add_axes(figure, left, up, style.COLUMN_WIDTH - left - 0.08, _PANEL)
        _draw_panel(axes, values, edges)
        if size in others:
            _draw_line(axes, others[size], edges, len(values))
        letter = panels[row : row + 1]
        axes.set_title(
            f"({letter})  $N = {size}$, {counted(len(values), 'start')}", loc="left", pad=3
        )
        if row < count - 1:
            axes.tick_params(labelbottom=False)
    axes.set_xlabel("survival time, hidden / visible", labelpad=2)
    return figure


def _edges(values: Floats) -> Floats:
    """Edges of bins that hold all values; 1 is the middle of a bin."""
    low = math.floor((min(values.min(), 0.9) - 1.0) / _BIN + 0.5)
    high = math.ceil((max(values.max(), 1.0) - 1.0) / _BIN - 0.5)
    return 1.0 + _BIN * (np.arange(low, high + 2) - 0.5)


def _draw_panel(axes: Axes, values: Floats, edges: Floats) -> None:
    counts, _ = np.histogram(values, edges)
    middle = 0.5 * (edges[1:] + edges[:-1])
    at_one = np.abs(middle - 1.0) < 0.5 * _BIN
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
    one = int(counts[at_one][0])
    axes.annotate(
        f"$1 \\pm 0.005$: {one}",
        (1.0 - 0.5 * _BIN, one),
        xytext=(-2.0, -3.0),
        textcoords="offset points",
        ha="right",
        va="top",
        color=style.CAPTURED,
        fontsize=style.SMALL_TEXT_SIZE,
        path_effects=[withStroke(linewidth=2.0, foreground="white")],
    )
    axes.set_xlim(edges[0], edges[-1])
    axes.set_ylim(0.0, 1.08 * counts.max())
    axes.set_ylabel("starts", labelpad=3)
    axes.spines[["top", "right"]].set_visible(False)


def _draw_line(axes: Axes, values: Floats, edges: Floats, starts: int) -> None:
    """Draw the histogram of the assured pursuer as a line, scaled to a number of starts."""
    counts, _ = np.histogram(values, edges)
    heights = counts * starts / len(values)
    axes.stairs(heights, edges, color=style.PURSUER, linewidth=1.0, gid="assured")
    top = max(float(heights.max()), axes.get_ylim()[1] / 1.08)
    axes.set_ylim(0.0, 1.08 * top)
    axes.set_title(
        f"line: assured, {counted(len(values), 'start')}",
        loc="right",
        pad=3,
        color=style.PURSUER,
        fontsize=style.SMALL_TEXT_SIZE,
    )
