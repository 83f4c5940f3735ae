"""What happens where a team is close: smaller markers, and a close-up in a corner of the map."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from covey.model.validation import Floats
from covey.views.kit import style
from covey.views.kit.layout import camera_around, set_view

_LEAST_SCALE = 0.6
_ROOM = 1.3
"""Distance of two markers that are told apart, in their size."""

_SIDE, _MARGIN = 0.36, 0.02
"""Of the close-up, relative to the map."""
_CLOSE = 0.25
"""A team whose square is smaller than this, relative to the map, is shown closer."""


def fitting_scale(axes: Axes, points: Floats) -> float:
    """Return the scale, 1 at most, at which markers at `points` (K, 2) overlap least."""
    if len(points) < 2:
        return 1.0
    x, y = axes.transData.transform(points).T * 72.0 / axes.figure.dpi
    distances = np.hypot(x[:, None] - x, y[:, None] - y)
    closest = float(distances[np.triu_indices(len(points), 1)].min())
    return float(np.clip(closest / (_ROOM * style.EVADER_SIZE), _LEAST_SCALE, 1.0))


def close_up(axes: Axes, points: Floats, drawn: Floats) -> Axes | None:
    """Add a close-up of `points` (K, 2) in an empty corner.

    None if no corner is empty, or `points` are far apart. `drawn` (M, 2) are points of all that the
    map shows.
    """
    camera = camera_around(points, 0.2)
    low, high = axes.get_xlim()
    if camera.half_side > _CLOSE * 0.5 * (high - low):
        return None
    places = axes.transAxes.inverted().transform(axes.transData.transform(drawn))
    far = 1.0 - _SIDE - _MARGIN
    corners = [(x, y) for x in (_MARGIN, far) for y in (_MARGIN, far)]
    empty = [
        corner
        for corner in corners
        if not ((places >= corner) & (places <= np.add(corner, _SIDE))).all(axis=1).any()
    ]
    if not empty:
        return None
    inset = axes.inset_axes((*empty[0], _SIDE, _SIDE))
    inset.set_zorder(style.TEXT_LAYER)
    set_view(inset, camera, ticks=False)
    axes.indicate_inset_zoom(inset, edgecolor=style.FAINT, linewidth=style.THIN_LINE, alpha=1.0)
    return inset
