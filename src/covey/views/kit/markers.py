"""The markers and lines of all pictures, as values, and the functions that draw them on a map."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.markers import MarkerStyle
from matplotlib.patches import Circle
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from covey.model.validation import Floats
from covey.views.kit import style


@dataclass(frozen=True)
class Marker:
    """A marker or a kind of line: its name (kept in SVG files), layer, and Line2D properties."""

    name: str
    layer: int
    properties: dict[str, Any]


def _marker(name: str, layer: int, marker: str, size: float, **properties: Any) -> Marker:
    shape = {"marker": marker, "markersize": size, "linestyle": "none"}
    return Marker(name, layer, shape | {f"marker{key}": properties[key] for key in properties})


_BLUE = {"facecolor": style.EVADER, "edgecolor": style.EVADER}
_HOLLOW = {"facecolor": style.PAPER, "edgecolor": style.EVADER, "edgewidth": 0.9}
_RED = {"facecolor": style.CAPTURED, "edgecolor": style.PAPER, "edgewidth": 0.6}
_THIN = {"edgecolor": style.INK, "edgewidth": 0.8}

EVADERS = _marker("evaders", style.EVADER_LAYER, "o", style.EVADER_SIZE, **_BLUE)
DOTS = _marker("dots", style.EVADER_LAYER, "o", style.DOT_SIZE, **_BLUE)
PREDICTED = _marker("predicted captures", style.EVADER_LAYER, "o", style.EVADER_SIZE, **_HOLLOW)
CAPTURED = _marker("captured evaders", style.CAPTURED_LAYER, "X", style.CAPTURED_SIZE, **_RED)
CENTER = _marker("disk center", style.EVADER_LAYER, "+", style.CENTER_SIZE, **_THIN)

FLOWN = Marker(
    "flown by evaders",
    style.FLOWN_LAYER,
    {"color": style.EVADER, "linewidth": style.EVADER_LINE, "solid_capstyle": "round"},
)
HEADINGS = Marker(
    "headings",
    style.FLOWN_LAYER,
    {"color": style.EVADER, "linewidth": 1.0},
)
PLANNED = Marker(
    "planned by evaders",
    style.PLANNED_LAYER,
    {"color": style.EVADER, "linewidth": 1.0, "linestyle": style.PLANNED_DASHES},
)
PURSUER_FLOWN = Marker(
    "flown by pursuer",
    style.PURSUIT_LAYER,  # in front: at the end of a chase the pursuer flies along an evader's path
    {"color": style.PURSUER, "linewidth": style.PURSUER_LINE},
)
PURSUER_PREDICTED = Marker(
    "predicted of pursuer",
    style.PLANNED_LAYER,
    {"color": style.PURSUER, "linewidth": style.PURSUER_LINE, "linestyle": style.PURSUER_DOTS},
)

_DISK_LOOK: dict[str, Any] = {
    "facecolor": style.DISK,
    "edgecolor": style.DISK_EDGE,
    "linewidth": style.THIN_LINE,
}

_DART = Path([(1.0, 0.0), (-0.75, 0.62), (-0.75, -0.62), (1.0, 0.0)], closed=True)
"""Flying along +x; longer than wide, so that its direction is seen."""


def pursuer_flying(heading: float) -> Marker:
    """The triangle of a pursuer that flies along `heading`."""
    properties = {
        "marker": MarkerStyle(_DART, transform=Affine2D().rotate(heading)),
        "markersize": style.PURSUER_SIZE,
        "markerfacecolor": style.PURSUER,
        "markeredgecolor": style.PAPER,
        "markeredgewidth": 0.5,
        "linestyle": "none",
    }
    return Marker("pursuer", style.PURSUER_LAYER, properties)


def draw(axes: Axes, marker: Marker, *paths: Floats, scale: float = 1.0) -> Line2D:
    """Draw a marker at all points of `paths`, each (K, 2); a line joins the points of one path."""
    gap = np.full((1, 2), np.nan)
    pieces = [piece for path in paths for piece in (gap, np.reshape(path, (-1, 2)))]
    x, y = np.concatenate(pieces[1:] or [np.empty((0, 2))]).T
    line = Line2D(x, y, zorder=marker.layer, gid=marker.name, **marker.properties)
    line.set_markersize(scale * line.get_markersize())
    line.set_markeredgewidth(scale * line.get_markeredgewidth())
    axes.add_line(line)
    return line


def draw_disk(axes: Axes, center: Floats, radius: float, **properties: Any) -> Circle:
    """Draw a disk, grey unless `properties` say otherwise; a disk of radius 0 isn't seen."""
    x, y = center.tolist()
    disk = Circle((x, y), radius, zorder=style.DISK_LAYER, gid="disk", **(_DISK_LOOK | properties))
    axes.add_patch(disk)
    return disk


def legend_handle(marker: Marker, label: str) -> Line2D:
    """Return what stands for a marker in a legend."""
    return Line2D([], [], label=label, **marker.properties)


def disk_handle(label: str) -> Line2D:
    """Return what stands for the disk in a legend."""
    properties = {f"marker{part}": _DISK_LOOK[part] for part in ("facecolor", "edgecolor")}
    return Line2D([], [], label=label, marker="o", markersize=9.0, linestyle="none", **properties)
