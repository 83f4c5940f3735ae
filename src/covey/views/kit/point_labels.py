"""Labels beside points, each at the position where it hides least."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Annotation, Text
from matplotlib.transforms import Bbox

from covey.model.validation import Floats
from covey.views.kit import style
from covey.views.kit.sampling import marked

_DISTANCES = (5.0, 8.0, 12.0, 17.0, 24.0, 33.0)
"""From the mark to the label's edge, typographic points."""

_DIRECTIONS = tuple(math.tau * k / 16 for k in range(16))
_OVERLAP, _OUTSIDE, _FAR = 1000.0, 1000.0, 0.2
"""Cost of a position: for each label that it overlaps, for leaving the map, for each typographic
point of distance. Each hidden point of a line costs 1."""

_LEADER = {
    "arrowstyle": "-",
    "color": style.FAINT,
    "linewidth": 0.5 * style.THIN_LINE,
    "shrinkA": 0.0,
    "shrinkB": 0.0,
}
_NEAR = 9.0
"""A hair line joins a mark and its label if they are farther apart, typographic points."""


NUMBER: dict[str, Any] = {"color": style.EVADER, "fontweight": "bold"}
"""How the number of an evader looks beside it."""


def label(
    axes: Axes,
    points: Floats,
    texts: Sequence[str],
    lines: Floats,
    size: float = style.SMALL_TEXT_SIZE,
    looks: Sequence[dict[str, Any]] | None = None,
    clear_of: Sequence[Axes] = (),
) -> list[Annotation]:
    """Write a text beside each of `points` (K, 2), clear of other labels and of `lines` (M, 2).

    Greedy: one label after the other takes the best position that is left. The axes must have their
    final position and limits. `looks` are properties of each text; `clear_of` are other axes that
    lie on these.
    """
    drawn = axes.transData.transform(np.concatenate([lines, marked(points)]))
    taken: list[Bbox] = [each.get_window_extent() for each in clear_of]
    labels = []
    for point, text, look in zip(points, texts, looks or [{}] * len(texts), strict=True):
        note = _note(axes, point, text, {"fontsize": size} | look)
        distance, offset, box = _best_position(axes, note, drawn, taken)
        note.set_position(offset)
        if note.arrow_patch is not None:
            note.arrow_patch.set_visible(distance > _NEAR)
        taken.append(box)
        labels.append(note)
    return labels


def footprint(axes: Axes, text: Text) -> Floats:
    """Points (K, 2) all over a text, for labels to keep clear of."""
    box = text.get_window_extent()
    shares = np.linspace(0.0, 1.0, 5)
    grid = [(box.x0 + a * box.width, box.y0 + b * box.height) for a in shares for b in shares]
    points: Floats = axes.transData.inverted().transform(grid)
    return points


def number_evaders(
    axes: Axes, points: Floats, evaders: Sequence[int], lines: Floats
) -> list[Annotation]:
    """Write the number of each evader beside its point, (K, 2), clear of `lines` (M, 2)."""
    looks = [NUMBER] * len(evaders)
    return label(axes, points, [str(i) for i in evaders], lines, looks=looks)


def _note(axes: Axes, point: Floats, text: str, look: dict[str, Any]) -> Annotation:
    return axes.annotate(
        text,
        (float(point[0]), float(point[1])),
        xytext=(0.0, 0.0),
        textcoords="offset points",
        ha="center",
        va="center",
        arrowprops=_LEADER,
        **look,
        zorder=style.TEXT_LAYER,
    )


def _best_position(
    axes: Axes, note: Annotation, drawn: Floats, taken: list[Bbox]
) -> tuple[float, tuple[float, float], Bbox]:
    """Distance and offset from the point, typographic points, and the label's box, pixels."""
    pixels = axes.figure.dpi / 72.0
    extent = note.get_window_extent()
    half_width, half_height = 0.5 * extent.width / pixels, 0.5 * extent.height / pixels
    x, y = axes.transData.transform(note.xy)
    best = (math.inf, 0.0, (0.0, 0.0), extent)
    for distance in _DISTANCES:
        for angle in _DIRECTIONS:
            across = _offset(distance, half_width, math.cos(angle))
            up = _offset(distance, half_height, math.sin(angle))
            box = Bbox.from_bounds(
                x + pixels * (across - half_width),
                y + pixels * (up - half_height),
                extent.width,
                extent.height,
            )
            cost = _cost(box, drawn, taken, axes.bbox) + _FAR * distance
            if cost < best[0]:
                best = (cost, distance, (across, up), box)
    return best[1:]


def _offset(distance: float, half_size: float, share: float) -> float:
    """Along an axis, from a point to the middle of a box whose edge is `distance` away.

    `share` is the cosine or the sine of the direction. On a diagonal the corner of the box is next.
    """
    return distance * share + half_size * max(-1.0, min(1.0, math.sqrt(2.0) * share))


def _cost(box: Bbox, drawn: Floats, taken: list[Bbox], page: Bbox) -> float:
    inside = page.x0 < box.x0 and box.x1 < page.x1 and page.y0 < box.y0 and box.y1 < page.y1
    hidden = box.padded(2.0).count_contains(drawn)
    return hidden + _OVERLAP * box.count_overlaps(taken) + (0.0 if inside else _OUTSIDE)
