"""Figures and axes of exact size, and the square of the plane that they show."""

from __future__ import annotations

from collections.abc import Iterable
from string import ascii_lowercase
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, NullLocator

from covey.model.validation import Floats
from covey.views.kit.style import COLUMN_WIDTH

TITLE = 0.22
"""Headroom for a title, inches."""


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
    """An empty figure, sizes in inches. pyplot's global state doesn't hold it."""
    figure = Figure(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def add_axes(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Axes at an exact position in the figure, inches."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))


def panels_in_a_row(
    titles: Iterable[str], side: float, headroom: float
) -> tuple[Figure, list[Axes]]:
    """Panels of height `side` with lettered titles; the first has the tick labels of y; inches.

    Two panels are two columns of a paper wide.
    """
    titles = list(titles)
    left, bottom, gap = 0.5, 0.4, 0.18
    width = (2.0 * COLUMN_WIDTH - left - 0.28 - gap) / 2.0
    figure = new_figure(left + len(titles) * (width + gap) + 0.1, bottom + side + headroom)
    panels = []
    for k, title in enumerate(titles):
        axes = add_axes(figure, left + k * (width + gap), bottom, width, side)
        axes.set_title(f"({ascii_lowercase[k]})  {title}", loc="left", pad=3)
        axes.tick_params(labelleft=k == 0)
        panels.append(axes)
    return figure, panels


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


def single_map(
    camera: Camera, *, ticks: bool = True, headroom: float = 0.08
) -> tuple[Figure, Axes]:
    """A figure one column wide with one square map, and `headroom` above the map, inches."""
    letter = 0.2
    left, right, bottom = letter, 0.06, letter + 0.02
    if ticks:
        numbers, right = margins(camera)
        left, bottom = letter + numbers, letter + 0.18
    side = COLUMN_WIDTH - left - right
    figure = new_figure(COLUMN_WIDTH, bottom + side + headroom)
    axes = add_axes(figure, left, bottom, side, side)
    set_view(axes, camera, ticks=ticks)
    axes.set_xlabel("$x$", labelpad=1)
    axes.set_ylabel("$y$", labelpad=1)
    return figure, axes
