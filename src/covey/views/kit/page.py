"""Figures and axes of exact size: a new figure, or the place of given axes. Sizes are inches."""

from __future__ import annotations

import math
from io import BytesIO
from typing import Any, NamedTuple, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from covey.model.validation import number
from covey.views.kit.style import COLUMN_WIDTH, SMALL_TEXT_SIZE

TITLE = 0.22
"""Headroom for a title."""
_CLEAR = 0.04
"""From a title to the edge of its place."""

_NOTEBOOK_DPI = 150


class Picture(Figure):
    """A figure that shows itself in a notebook. pyplot's global state doesn't hold it."""

    def _repr_png_(self) -> bytes:
        buffer = BytesIO()
        self.savefig(buffer, format="png", dpi=_NOTEBOOK_DPI)
        return buffer.getvalue()


class Sheet(NamedTuple):
    """What a caller says of a whole picture."""

    ax: Axes | None  # where to draw; None: in a new figure
    title: str | None  # None or empty: no title
    width: float  # inches
    height: float = math.inf  # inches at most


def sheet_of(ax: Axes | None, title: str | None, width: float) -> Sheet:
    """Return a sheet of this width, 1 to 100 inches, or of the size of the given axes."""
    if ax is None:
        return Sheet(ax, title, number("width", width, low=1.0, high=100.0))
    width, height = (size / ax.figure.dpi for size in ax.get_window_extent().size)
    return Sheet(ax, title, width, height)


class Page(NamedTuple):
    """What a picture of several panels is drawn on: a new figure, or the place of given axes."""

    figure: Figure
    axes: Axes | None  # the given ones
    width: float  # inches, as all lengths here
    height: float

    def panel(self, left: float, bottom: float, width: float, height: float) -> Axes:
        """Add axes at an exact position; within given axes, at the same share of their place."""
        if self.axes is None:
            return add_axes(self.figure, left, bottom, width, height)
        shares = left / self.width, bottom / self.height, width / self.width, height / self.height
        return self.axes.inset_axes(shares)

    def legend(self, *args: Any, **properties: Any) -> None:
        """Add a legend to the whole page, smaller on a page that is less than a column wide."""
        size = SMALL_TEXT_SIZE * min(1.0, self.width / COLUMN_WIDTH)
        properties = {"fontsize": size} | properties
        (self.axes or self.figure).legend(*args, **properties)

    def text(self, left: float, bottom: float, text: str, **properties: Any) -> Text:
        """Write a text at an exact position."""
        place = left / self.width, bottom / self.height
        if self.axes is None:
            return self.figure.text(*place, text, **properties)
        return self.axes.text(*place, text, transform=self.axes.transAxes, **properties)


def new_page(sheet: Sheet, height: float) -> Page:
    """Return a page in a new figure, or in the place of given axes; a title stands above it."""
    ax, title, width, _ = sheet
    whole = height + (TITLE if title else 0.0)
    if ax is None:
        page = Page(new_figure(width, whole), None, width, whole)
    else:
        ax.set_axis_off()
        page = Page(cast(Figure, ax.figure), ax, width, whole)
    if title:
        text = page.text(0.5 * width, 0.5 * (height + whole), title, ha="center", va="center")
        fit(text, width)
    return page


def fit(text: Text, width: float) -> None:
    """Write a title smaller if it leaves its place: so wide, and as high as the headroom."""
    place = np.array([width - _CLEAR, TITLE - _CLEAR]) * cast(Figure, text.figure).dpi
    # Letters are hinted, so that the width isn't quite in proportion to the size.
    while (share := float(np.min(place / text.get_window_extent().size))) < 1.0:
        text.set_fontsize(0.99 * share * float(text.get_fontsize()))


def new_figure(width: float, height: float) -> Figure:
    """An empty figure, sizes in inches."""
    figure = Picture(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def add_axes(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Axes at an exact position in the figure, inches."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))
