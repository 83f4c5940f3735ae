"""Figures and axes of exact size, and the square of the plane that they show."""

from __future__ import annotations

import math
from collections.abc import Sequence
from io import BytesIO
from string import ascii_lowercase
from typing import Any, NamedTuple, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, NullLocator

from covey.model.units import titled
from covey.model.validation import Floats
from covey.views.kit.style import COLUMN_WIDTH

TITLE = 0.22
"""Headroom for a title, inches."""

_NOTEBOOK_DPI = 150
_LEAST_SIDE = 0.5
"""Of a map, inches."""
_LETTER = 0.2
"""Height of the name of an axis, inches."""


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
    """Return a sheet of this width, inches, or of the size of the given axes."""
    if ax is None:
        return Sheet(ax, title, width)
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
        """Add a legend to the whole page."""
        (self.axes or self.figure).legend(*args, **properties)

    def text(self, left: float, bottom: float, text: str, **properties: Any) -> None:
        """Write a text at an exact position."""
        place = left / self.width, bottom / self.height
        if self.axes is None:
            self.figure.text(*place, text, **properties)
        else:
            self.axes.text(*place, text, transform=self.axes.transAxes, **properties)


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
        page.text(0.5 * width, 0.5 * (height + whole), title, ha="center", va="center")
    return page


class Camera(NamedTuple):
    """The square of the plane that is shown: its center and half its side, lengths."""

    x: float
    y: float
    half_side: float


def camera_around(points: Floats, margin: float = 0.08) -> Camera:
    """Smallest square around `points` (K, 2), widened on each side by `margin` times its side."""
    low, high = points.min(axis=0), points.max(axis=0)
    x, y = (0.5 * (low + high)).tolist()
    side = float(np.max(high - low)) or 1.0
    return Camera(x, y, side * (0.5 + margin))


def new_figure(width: float, height: float) -> Figure:
    """An empty figure, sizes in inches."""
    figure = Picture(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def add_axes(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Axes at an exact position in the figure, inches."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))


def width_of_panels(count: int) -> float:
    """Return the width of some panels in a row, inches; two are two columns of a paper wide."""
    return COLUMN_WIDTH * count


def panels_in_a_row(
    names: Sequence[str], side: float, headroom: float, sheet: Sheet
) -> tuple[Page, list[Axes]]:
    """Panels of height `side` with lettered names; the first has the tick labels of y; inches."""
    left, bottom, gap, right = 0.5, 0.4, 0.18, 0.1
    across = (sheet.width - left - right + gap) / len(names) - gap
    page = new_page(sheet, bottom + side + headroom)
    panels = []
    for k, name in enumerate(names):
        axes = page.panel(left + k * (across + gap), bottom, across, side)
        axes.set_title(f"({ascii_lowercase[k]})  {name}", loc="left", pad=3)
        axes.tick_params(labelleft=k == 0)
        panels.append(axes)
    return page, panels


def set_view(axes: Axes, camera: Camera, *, ticks: bool = True) -> None:
    """Show the camera's square. Artists that are added later don't change the limits."""
    x, y, half = camera
    axes.set_aspect("equal")
    axes.set_xlim(x - half, x + half)
    axes.set_ylim(y - half, y + half)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10]) if ticks else NullLocator())
    if ticks:
        axes.ticklabel_format(style="plain", useOffset=False)
    axes.autoscale(enable=False)
    locator: Any = axes.get_axes_locator()  # of axes within others, else None
    axes.apply_aspect(locator(axes, None) if locator else None)  # labels need the final position


def margins(camera: Camera) -> tuple[float, float]:
    """Inches left and right of a map for its tick labels, measured: lengths are in any unit."""
    figure = new_figure(COLUMN_WIDTH, COLUMN_WIDTH)
    axes = add_axes(figure, 1.0, 1.0, 2.0, 2.0)
    set_view(axes, camera)
    beside, below = (
        max((number.get_window_extent().width for number in numbers), default=0.0) / figure.dpi
        for numbers in (axes.get_yticklabels(), axes.get_xticklabels())
    )
    return beside + 0.13, max(0.08, 0.55 * below)


def name_axes(axes: Axes, unit: str, *, below: bool = True, beside: bool = True) -> None:
    """Write x below a map, and y beside it, with the unit of length."""
    if below:
        axes.set_xlabel(titled("$x$", unit), labelpad=1)
    if beside:
        axes.set_ylabel(titled("$y$", unit), labelpad=1)


def maps_in_rows(
    names: Sequence[str], columns: int, camera: Camera, unit: str, foot: float, sheet: Sheet
) -> tuple[Page, list[Axes]]:
    """Square maps with names, all through one camera; `foot` inches below them stay free."""
    numbers, right = margins(camera)
    left, gap, above = numbers + _LETTER, 0.08, 0.20
    side = (sheet.width - left - right - (columns - 1) * gap) / columns
    rows = -(-len(names) // columns)
    room = sheet.height - foot - (TITLE if sheet.title else 0.0)
    side = max(min(side, room / rows - above), _LEAST_SIDE)
    page = new_page(sheet, foot + rows * (side + above))
    left += 0.5 * (sheet.width - left - right - columns * side - (columns - 1) * gap)
    maps = []
    for k, name in enumerate(names):
        down, across = divmod(k, columns)
        bottom = foot + (rows - 1 - down) * (side + above)
        axes = page.panel(left + across * (side + gap), bottom, side, side)
        set_view(axes, camera)
        lowest = k + columns >= len(names)
        axes.tick_params(labelleft=across == 0, labelbottom=lowest)
        name_axes(axes, unit, below=lowest, beside=across == 0)
        axes.set_title(name, loc="left", pad=3)
        maps.append(axes)
    return page, maps


def single_map(
    camera: Camera, sheet: Sheet, unit: str = "", *, ticks: bool = True
) -> tuple[Figure, Axes]:
    """One square map: in a new figure, or the given axes. Without a title, no room for one."""
    ax, title, width, _ = sheet
    if ax is not None:
        figure, axes = cast(Figure, ax.figure), ax
    else:
        figure, axes = _map_figure(camera, ticks, TITLE if title else 0.08, width)
    set_view(axes, camera, ticks=ticks)
    name_axes(axes, unit)
    if title:
        axes.set_title(title, loc="left", pad=4)
    return figure, axes


def _map_figure(camera: Camera, ticks: bool, headroom: float, width: float) -> tuple[Figure, Axes]:
    left, right, bottom = _LETTER, 0.06, _LETTER + 0.02
    if ticks:
        numbers, right = margins(camera)
        left, bottom = _LETTER + numbers, _LETTER + 0.18
    side = width - left - right
    figure = new_figure(width, bottom + side + headroom)
    return figure, add_axes(figure, left, bottom, side, side)
