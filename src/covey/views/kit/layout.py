"""Maps and panels on a page: the square of the plane that is shown, and rows of axes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import Any, NamedTuple, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator, NullLocator

from covey.model.units import titled
from covey.model.validation import Floats
from covey.views.kit.page import TITLE, Page, Sheet, add_axes, fit, new_figure, new_page
from covey.views.kit.style import COLUMN_WIDTH, TEXT_SIZE

_LEAST_SIDE = 0.5
"""Of a map, inches."""
_SMALL_SIDE = 0.8
"""Of a map with few numbers at its axes, inches."""
_LETTER = 0.2
"""Height of the name of an axis, inches."""
_APART = 0.03
"""Half of the least distance between two numbers at an axis, inches."""


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


def width_of_panels(count: int) -> float:
    """Return the width of some panels in a row, inches; two are two columns of a paper wide."""
    return COLUMN_WIDTH * count


def lettered(names: Sequence[str]) -> list[str]:
    """Put (a), (b), ... before the names of several panels. A single panel needs no letter."""
    if len(names) == 1:
        return [*names]
    return [f"({chr(ord('a') + k)})  {name}" for k, name in enumerate(names)]


def panels_in_a_row(
    names: Sequence[str], side: float, headroom: float, sheet: Sheet
) -> tuple[Page, list[Axes]]:
    """Panels of height `side` with their names; the first has the tick labels of y; inches."""
    left, bottom, gap, right = 0.5, 0.4, 0.18, 0.1
    across = (sheet.width - left - right + gap) / len(names) - gap
    page = new_page(sheet, bottom + side + headroom)
    panels = []
    for k, name in enumerate(lettered(names)):
        axes = page.panel(left + k * (across + gap), bottom, across, side)
        fit(axes.set_title(name, loc="left", pad=3), across)
        axes.tick_params(labelleft=k == 0)
        panels.append(axes)
    return page, panels


def set_view(axes: Axes, camera: Camera, *, ticks: bool = True) -> None:
    """Show the camera's square. Artists that are added later don't change the limits."""
    x, y, half = camera
    axes.set_aspect("equal")
    axes.set_xlim(x - half, x + half)
    axes.set_ylim(y - half, y + half)
    most = 4 if axes.get_window_extent().width > _SMALL_SIDE * axes.figure.dpi else 2
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(most, steps=[1, 2, 5, 10]) if ticks else NullLocator())
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
    """Square maps with names, all through one camera; `foot` inches below them stay free.

    There are at most so many columns: as many as leave room for the names, or those in which the
    maps are largest. Where a map is narrower than its name, the name is written smaller.
    """
    numbers, right = margins(camera)
    left, gap, above = numbers + _LETTER, 0.08, 0.20
    room = sheet.height - foot - (TITLE if sheet.title else 0.0)

    def side_in(columns: int) -> float:
        across = (sheet.width - left - right - (columns - 1) * gap) / columns
        return max(min(across, room / -(-len(names) // columns) - above), _LEAST_SIDE)

    widest = _width_of_titles(names)
    possible = range(columns, 0, -1)
    largest = max(possible, key=side_in)
    columns = next((each for each in possible if side_in(each) >= widest), largest)
    side, rows = side_in(columns), -(-len(names) // columns)
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
        axes.set_title(name, loc="left", pad=3, fontsize=TEXT_SIZE * min(1.0, side / widest))
        maps.append(axes)
    if _touch(maps):  # the first number of a map touches the last one of its neighbour
        for k, axes in enumerate(maps):
            if k % columns > 0:
                for number in _numbers_below(axes)[:1]:
                    number.set_visible(False)
    if _touch(maps):
        for k, axes in enumerate(maps):
            axes.tick_params(labelbottom=k % columns == 0 and k + columns >= len(names))
    return page, maps


def _width_of_titles(names: Sequence[str]) -> float:
    """Inches that the widest of some titles takes, measured."""
    axes = add_axes(new_figure(COLUMN_WIDTH, COLUMN_WIDTH), 0.0, 0.0, 1.0, 1.0)
    titles = (axes.text(0.0, 0.0, name, fontsize=TEXT_SIZE) for name in names)
    return max(float(each.get_window_extent().width) / axes.figure.dpi for each in titles)


def _touch(maps: Sequence[Axes]) -> bool:
    """Whether numbers below some maps touch each other: those of neighbours are as high."""
    boxes = [
        number.get_window_extent().padded(_APART * axes.figure.dpi)
        for axes in maps
        for number in _numbers_below(axes)
    ]
    return any(one.overlaps(other) for one, other in combinations(boxes, 2))


def _numbers_below(axes: Axes) -> list[Text]:
    """Return the numbers that stand below a map; matplotlib keeps others, outside of the view."""
    low, high = axes.get_xlim()
    numbers = [each for each in axes.get_xticklabels() if each.get_visible()]
    return [each for each in numbers if low <= each.get_position()[0] <= high]


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
        room = width if ax is not None else width * (1.0 - axes.get_position().x0)
        fit(axes.set_title(title, loc="left", pad=4), room)
    return figure, axes


def _map_figure(camera: Camera, ticks: bool, headroom: float, width: float) -> tuple[Figure, Axes]:
    left, right, bottom = _LETTER, 0.06, _LETTER + 0.02
    if ticks:
        numbers, right = margins(camera)
        left, bottom = _LETTER + numbers, _LETTER + 0.18
    side = width - left - right
    figure = new_figure(width, bottom + side + headroom)
    return figure, add_axes(figure, left, bottom, side, side)
