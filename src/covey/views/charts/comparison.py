"""Chart: ratios of means with confidence intervals, one strip for each strategy or objective."""

from __future__ import annotations

from collections.abc import Sequence
from string import ascii_lowercase
from textwrap import fill
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from covey.model import InputError
from covey.views.kit import style
from covey.views.kit.layout import add_axes, new_figure
from covey.views.kit.style import styled

_STRIP = 0.27
"""Height of a strip, inches."""

_LETTER = 0.058
"""Approximate width of a letter, inches."""


class Ratio(NamedTuple):
    """A ratio of means, and its position in the picture."""

    row: str  # of panels, from the top
    column: str
    strip: str  # of the panel
    size: int
    value: float
    error: float  # half width of its confidence interval


@styled
def draw_comparison(ratios: Sequence[Ratio], label: str) -> Figure:
    """Draw how teams, or objectives, compare with a reference among them.

    Parameters
    ----------
    ratios
        In the order of rows, columns, strips and sizes in the picture.
    label
        Label of the axis: what the ratios are.

    Returns
    -------
    matplotlib.figure.Figure
        Two columns of a paper wide. All panels have one scale.

    Raises
    ------
    InputError
        If there is nothing to draw.
    """
    if not ratios:
        raise InputError("ratios: expected at least one")
    rows, columns, strips, sizes = (
        list(dict.fromkeys(getattr(ratio, part) for ratio in ratios))
        for part in ("row", "column", "strip", "size")
    )
    left = _LETTER * (max(map(len, strips)) + 2)
    bottom, gap, between, top = 0.38, 0.08, 0.5, 0.48
    full = 2.0 * style.COLUMN_WIDTH
    width = (full - left - 0.08 - (len(columns) - 1) * gap) / len(columns)
    height = _STRIP * len(strips)
    figure = new_figure(full, bottom + len(rows) * height + (len(rows) - 1) * between + top)
    low, high = _limits(ratios)
    for i, row in enumerate(rows):
        for j, column in enumerate(columns):
            up = bottom + (len(rows) - 1 - i) * (height + between)
            axes = add_axes(figure, left + j * (width + gap), up, width, height)
            chosen = [ratio for ratio in ratios if (ratio.row, ratio.column) == (row, column)]
            _draw_panel(axes, chosen, strips, sizes)
            axes.set_xlim(low, high)
            title = fill(column, max(1, int(width / _LETTER)), break_long_words=False)
            axes.set_title(title, pad=3, fontsize=style.SMALL_TEXT_SIZE)
            if j == 0:
                axes.set_yticks(range(len(strips)), strips)
                axes.annotate(
                    f"({ascii_lowercase[i]})  {row}",
                    (0.0, 1.0),
                    xytext=(-72.0 * left, 15.0),
                    xycoords="axes fraction",
                    textcoords="offset points",
                )
            if i < len(rows) - 1:
                axes.tick_params(labelbottom=False)
    handles, names = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="upper right", ncols=len(sizes), borderaxespad=0.2)
    figure.supxlabel(label, y=0.04 / figure.get_figheight(), fontsize=style.TEXT_SIZE)
    return figure


def _limits(ratios: Sequence[Ratio]) -> tuple[float, float]:
    low = min(1.0, *(ratio.value - ratio.error for ratio in ratios))
    high = max(1.0, *(ratio.value + ratio.error for ratio in ratios))
    margin = 0.04 * (high - low) or 0.1
    return low - margin, high + margin


def _draw_panel(
    axes: Axes, ratios: Sequence[Ratio], strips: Sequence[str], sizes: Sequence[int]
) -> None:
    for k, size in enumerate(sizes):
        chosen = [ratio for ratio in ratios if ratio.size == size]
        offset = (k + 0.5) / len(sizes) - 0.5
        axes.errorbar(
            [ratio.value for ratio in chosen],
            [strips.index(ratio.strip) + 0.8 * offset for ratio in chosen],
            xerr=[ratio.error for ratio in chosen],
            markersize=0.5 * style.EVADER_SIZE,
            linestyle="none",
            gid=f"teams of {size}",
            **style.team_size_series(k, size),
        )
    for boundary in range(len(strips) - 1):
        axes.axhline(boundary + 0.5, color=style.DISK, linewidth=0.5 * style.THIN_LINE)
    axes.axvline(1.0, **style.GUIDE)
    axes.set_ylim(len(strips) - 0.5, -0.5)
    axes.set_yticks([])
    axes.xaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10], prune="both"))
    axes.spines[["top", "right"]].set_visible(False)
