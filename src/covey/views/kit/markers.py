"""The signs of all pictures, as values, and the functions that put them on a map."""

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
class Sign:
    """A mark or a kind of line: its name (which an SVG file keeps), its layer and its look."""

    name: str
    layer: int
    look: dict[str, Any]


def _mark(name: str, layer: int, marker: str, size: float, **look: Any) -> Sign:
    shape = {"marker": marker, "markersize": size, "linestyle": "none"}
    return Sign(name, layer, shape | {f"marker{key}": look[key] for key in look})


_BLUE = {"facecolor": style.EVADER, "edgecolor": style.EVADER}
_HOLLOW = {"facecolor": style.PAPER, "edgecolor": style.EVADER, "edgewidth": 0.9}
_RED = {"facecolor": style.CAPTURED, "edgecolor": style.PAPER, "edgewidth": 0.6}
_THIN = {"edgecolor": style.INK, "edgewidth": 0.8}

EVADERS = _mark("evaders", style.EVADER_LAYER, "o", style.EVADER_SIZE, **_BLUE)
DOTS = _mark("dots", style.EVADER_LAYER, "o", style.DOT_SIZE, **_BLUE)
PREDICTED = _mark("predicted captures", style.EVADER_LAYER, "o", style.EVADER_SIZE, **_HOLLOW)
CAPTURED = _mark("captured evaders", style.CAPTURED_LAYER, "X", style.CAPTURED_SIZE, **_RED)
CENTER = _mark("disk center", style.EVADER_LAYER, "+", style.CENTER_SIZE, **_THIN)

FLOWN = Sign(
    "flown by evaders",
    style.FLOWN_LAYER,
    {"color": style.EVADER, "linewidth": style.EVADER_LINE, "solid_capstyle": "round"},
)
PLANNED = Sign(
    "planned by evaders",
    style.PLANNED_LAYER,
    {"color": style.EVADER, "linewidth": 1.0, "linestyle": style.PLANNED_DASHES},
)
PURSUER_FLOWN = Sign(
    "flown by pursuer",
    style.PURSUIT_LAYER,  # in front: at the end of a chase it flies along the evader's own track
    {"color": style.PURSUER, "linewidth": style.PURSUER_LINE},
)
PURSUER_PREDICTED = Sign(
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
"""Flying along +x; longer than wide, so that one sees where it points."""


def pursuer_flying(heading: float) -> Sign:
    """The triangle of a pursuer that flies along `heading`."""
    look = {
        "marker": MarkerStyle(_DART, transform=Affine2D().rotate(heading)),
        "markersize": style.PURSUER_SIZE,
        "markerfacecolor": style.PURSUER,
        "markeredgecolor": style.PAPER,
        "markeredgewidth": 0.5,
        "linestyle": "none",
    }
    return Sign("pursuer", style.PURSUER_LAYER, look)


def put(axes: Axes, sign: Sign, *paths: Floats, scale: float = 1.0) -> Line2D:
    """Put a sign at all points of `paths`, each (K, 2); lines join the points within a path."""
    gap = np.full((1, 2), np.nan)
    pieces = [piece for path in paths for piece in (gap, np.reshape(path, (-1, 2)))]
    x, y = np.concatenate(pieces[1:] or [np.empty((0, 2))]).T
    line = Line2D(x, y, zorder=sign.layer, gid=sign.name, **sign.look)
    line.set_markersize(scale * line.get_markersize())
    axes.add_line(line)
    return line


def put_disk(axes: Axes, center: Floats, radius: float, **look: Any) -> Circle:
    """Put a disk, grey unless `look` says otherwise; of radius 0 it is a point and isn't seen."""
    x, y = center.tolist()
    disk = Circle((x, y), radius, zorder=style.DISK_LAYER, gid="disk", **(_DISK_LOOK | look))
    axes.add_patch(disk)
    return disk


def key(sign: Sign, label: str) -> Line2D:
    """What stands for a sign in a legend."""
    return Line2D([], [], label=label, **sign.look)


def disk_key(label: str) -> Line2D:
    """What stands for the disk in a legend."""
    look = {f"marker{part}": _DISK_LOOK[part] for part in ("facecolor", "edgecolor")}
    return Line2D([], [], label=label, marker="o", markersize=9.0, linestyle="none", **look)
