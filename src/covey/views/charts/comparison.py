"""Chart: ratios of means with confidence intervals, one strip for each strategy or objective."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from textwrap import fill
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from covey.model import InputError
from covey.views.kit import style
from covey.views.kit.layout import lettered
from covey.views.kit.page import Page, Sheet, fit, new_page, sheet_of
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
def draw_comparison(
    ratios: Sequence[Ratio],
    label: str,
    *,
    reference: float | None = 1.0,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = 2.0 * style.COLUMN_WIDTH,
) -> Figure:
    """Draw how teams, or objectives, compare with a reference among them.

    Parameters
    ----------
    ratios
        In the order of rows, columns, strips and sizes in the picture.
    label
        Label of the axis: what the ratios are.
    reference
        A value at which a line is drawn. None: no line.
    ax
        Axes in whose place the panels are drawn. Default: a new figure.
    title
        Above all panels. Default: none.
    width
        Of a new figure, inches. Default: two columns of a paper, 7.

    Returns
    -------
    matplotlib.figure.Figure
        All panels have one scale.

    Raises
    ------
    InputError
        If there is nothing to draw.

    Examples
    --------
    >>> from covey import views
    >>> ratio = views.Ratio("open-loop", "committed", "", size=3, value=0.97, error=0.01)
    >>> figure = views.draw_comparison([ratio], "survival time")
    """
    if not ratios:
        raise InputError("ratios: expected at least one")
    rows, columns, strips, sizes = (
        list(dict.fromkeys(getattr(ratio, part) for ratio in ratios))
        for part in ("row", "column", "strip", "size")
    )
    sheet = sheet_of(ax, title, width)
    left = _LETTER * (max(map(len, strips)) + 2)
    page, panels = _add_panels(sheet, rows, columns, left, _STRIP * len(strips))
    limits = _limits(ratios, reference)
    for (row, column), axes in panels.items():
        chosen = [ratio for ratio in ratios if (ratio.row, ratio.column) == (row, column)]
        _draw_panel(axes, chosen, strips, sizes)
        if reference is not None:
            axes.axvline(reference, **style.GUIDE)
        axes.set_xlim(limits)
        axes.tick_params(labelbottom=row == rows[-1])
    for name, row in zip(lettered(rows), rows, strict=True):
        first = panels[row, columns[0]]
        first.set_yticks(range(len(strips)), strips)
        _name_row(first, name, left)
    handles, names = panels[rows[0], columns[0]].get_legend_handles_labels()
    page.legend(handles, names, loc="upper right", ncols=len(sizes), borderaxespad=0.2)
    text = page.text(0.5 * sheet.width, 0.04, label, ha="center", va="bottom")
    fit(text, sheet.width)
    return page.figure


def _add_panels(
    sheet: Sheet, rows: Sequence[str], columns: Sequence[str], left: float, height: float
) -> tuple[Page, dict[tuple[str, str], Axes]]:
    """Return a page with a panel for each row and column, of this height, `left` of it free."""
    bottom, gap, between, top = 0.38, 0.08, 0.5, 0.48
    width = (sheet.width - left - 0.08 - (len(columns) - 1) * gap) / len(columns)
    page = new_page(sheet, bottom + len(rows) * height + (len(rows) - 1) * between + top)
    panels = {}
    for (i, row), (j, column) in product(enumerate(rows), enumerate(columns)):
        up = bottom + (len(rows) - 1 - i) * (height + between)
        axes = page.panel(left + j * (width + gap), up, width, height)
        name = fill(column, max(1, int(width / _LETTER)), break_long_words=False)
        axes.set_title(name, pad=3, fontsize=style.SMALL_TEXT_SIZE)
        panels[row, column] = axes
    return page, panels


def _name_row(axes: Axes, name: str, left: float) -> None:
    """Write the name of a row over the strips of its first panel, `left` inches from it."""
    axes.annotate(
        name,
        (0.0, 1.0),
        xytext=(3.0 - 72.0 * left, 15.0),
        xycoords="axes fraction",
        textcoords="offset points",
    )


def _limits(ratios: Sequence[Ratio], reference: float | None) -> tuple[float, float]:
    ends = [] if reference is None else [reference]
    for ratio in ratios:
        error = ratio.error if math.isfinite(ratio.error) else 0.0  # nan: from a single start
        ends += [ratio.value - error, ratio.value + error]
    low, high = min(ends), max(ends)
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
            **style.team_size_series(k, size, len(sizes)),
        )
    for boundary in range(len(strips) - 1):
        axes.axhline(boundary + 0.5, color=style.DISK, linewidth=0.5 * style.THIN_LINE)
    axes.set_ylim(len(strips) - 0.5, -0.5)
    axes.set_yticks([])
    axes.xaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10], prune="both"))
    axes.spines[["top", "right"]].set_visible(False)
