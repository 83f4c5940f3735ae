"""What stands in a picture, in the coordinates of the game."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.patches import Circle
from matplotlib.text import Annotation, Text


def line(axes, name):
    """The one line or set of marks of that name."""
    (found,) = [line for line in axes.lines if line.get_gid() == name]
    return found


def points(axes, name):
    """Points (K, 2) of a marker, without the gaps between its paths."""
    positions = np.column_stack(line(axes, name).get_data()).astype(float)
    return positions[~np.isnan(positions).any(axis=1)]


def disks(axes):
    """All disks, in the order in which they are drawn."""
    found = [patch for patch in axes.patches if isinstance(patch, Circle)]
    return sorted(found, key=lambda disk: disk.get_zorder())


def bearing_of_marker(marks):
    """Direction in which the tip of a mark points, radians."""
    style = marks._marker  # there is no public way to it
    corners = style.get_transform().transform(style.get_path().vertices)
    x, y = corners[np.argmax(np.hypot(*corners.T))]
    return math.atan2(y, x)


def labels(axes):
    """The labels beside points."""
    return [text for text in axes.texts if isinstance(text, Annotation)]


def boxes(axes):
    """What each label fills, without the line that leads to it, pixels."""
    axes.figure.canvas.draw()
    return [Text.get_window_extent(text) for text in labels(axes)]


def numbers_below(axes):
    """What each number below a map fills, pixels; matplotlib keeps others, outside of the view."""
    low, high = axes.get_xlim()
    shown = [each for each in axes.get_xticklabels() if each.get_visible()]
    return [each.get_window_extent() for each in shown if low <= each.get_position()[0] <= high]
