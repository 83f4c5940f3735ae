"""The earliest capture of one evader by a pursuer from a disk (Fig. 2 of the paper)."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import PursuerDisk, Team
from covey.model.angles import unit_vectors
from covey.model.validation import Floats
from covey.planning import capture_times
from covey.views.charts.single_turn import SingleTurn, draw_arrow, single_turn
from covey.views.kit import style
from covey.views.kit.layout import camera_around, single_map
from covey.views.kit.markers import (
    CENTER,
    DOTS,
    EVADERS,
    FLOWN,
    PLANNED,
    PREDICTED,
    draw,
    draw_disk,
)
from covey.views.kit.page import sheet_of
from covey.views.kit.point_labels import footprint, label
from covey.views.kit.sampling import joined, sampled
from covey.views.kit.style import styled

_PAPER_LIKE = Team([[1.1, 0.25]], [-0.6], speeds=0.6)
_PAPER_LIKE_TURN = 1.55
_PAPER_LIKE_DISK = PursuerDisk(radius=0.3)
_APART = math.radians(38.0)
"""Angle between the radii of the disks that are drawn."""

_UNIT_CIRCLE = unit_vectors(np.linspace(0.0, math.tau, 400))


@styled
def draw_capture(
    team: Team | None = None,
    disk: PursuerDisk | None = None,
    turn: float | None = None,
    *,
    evader: int = 0,
    ax: Axes | None = None,
    title: str = "",
    width: float = style.COLUMN_WIDTH,
) -> Figure:
    """Draw the minimum capture time of a path by a pursuer in a disk.

    This is eq. 7 and Fig. 2 of the paper.

    The disk D(x_c, r) is shown at three times: at 0, at the end of the evader's turn, and when the
    disk reaches the evader. The last is the earliest capture, at t*.

    Parameters
    ----------
    team, evader
        The evader; by default an example like the paper's.
    disk
        The pursuer's disk. With a capture radius ρ, r + ρ replaces r.
    turn
        Signed turn δ, radians.
    ax
        Axes to draw on. Default: a new figure.
    title
        Default: none.
    width
        Of a new figure, inches. Default: one column of a paper, 3.5.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the evader makes no turn, or isn't slower than the pursuer.

    Examples
    --------
    >>> from covey import views
    >>> figure = views.draw_capture()
    """
    motion = single_turn(
        _PAPER_LIKE if team is None else team, _PAPER_LIKE_TURN if turn is None else turn, evader
    )
    disk = _PAPER_LIKE_DISK if disk is None else disk
    capture = float(capture_times(motion.team, disk, [motion.turn], [0])[0])
    line = motion.path(max(capture, motion.turn_end))
    corners = disk.center + _reach(disk, 0.0) * np.array([[-1.0, -1.0], [1.0, 1.0]])
    camera = camera_around(joined([line, corners]), margin=0.12)
    figure, axes = single_map(camera, sheet_of(ax, title, width), ticks=False)
    edges = _draw_disks(axes, disk, motion, capture)
    _draw_path(axes, motion, capture)
    marked = np.array([motion.at(t) for t in (0.0, motion.turn_end, capture)])
    label(
        axes,
        np.vstack([marked, disk.center]),
        ["$x_e(0)$", "$x_e(t_c)$", "$x_e(t^*)$", "$x_c$"],
        joined([line, *edges]),
        style.TEXT_SIZE,
    )
    return figure


def _reach(disk: PursuerDisk, time: float) -> float:
    return disk.radius + disk.capture_radius + disk.speed * time


def _draw_disks(axes: Axes, disk: PursuerDisk, motion: SingleTurn, capture: float) -> list[Floats]:
    """Draw the disk at three times, the largest at the back, and a radius of each.

    Returns points that no label should hide.
    """
    base = "r" if disk.capture_radius == 0.0 else r"r + \rho"
    bearing, side = _bearing_and_free_side(disk.center, motion, capture)
    disks = [
        (0.0, f"${base}$", "#c4c4c4", "solid", bearing + math.pi),
        (motion.turn_end, f"${base} + v_p t_c$", "#dcdcdc", "dashed", bearing + side * _APART),
        (capture, f"${base} + v_p t^*$", "#f0f0f0", "dashdot", bearing),
    ]
    for time, _, grey, dashes, _ in sorted(disks, reverse=True):
        look = {"facecolor": grey, "edgecolor": style.INK, "linestyle": dashes}
        draw_disk(axes, disk.center, _reach(disk, time), **look)
    draw(axes, CENTER, disk.center)
    edges: list[Floats] = []
    for time, text, _, _, angle in disks:
        radius = _reach(disk, time)
        edges += _draw_radius(axes, disk.center, radius, angle, text)
        edges.append(disk.center + radius * _UNIT_CIRCLE)
    return edges


def _bearing_and_free_side(
    center: Floats, motion: SingleTurn, capture: float
) -> tuple[float, float]:
    """Bearing of the capture from the center, and the side of this line (+1: left) off the path."""
    x, y = (motion.at(capture) - center).tolist()
    start_x, start_y = (motion.at(0.0) - center).tolist()
    return math.atan2(y, x), -math.copysign(1.0, x * start_y - y * start_x)


def _draw_radius(
    axes: Axes, center: Floats, radius: float, angle: float, text: str
) -> list[Floats]:
    """Draw a line from the center to the rim, with an upright text along it.

    Returns points that no label should hide.
    """
    rim = center + radius * unit_vectors(angle)
    line = sampled(np.array([center, rim]))
    axes.plot(*line.T, color=style.INK, linewidth=style.THIN_LINE, gid="radius")
    upright = (math.degrees(angle) + 90.0) % 180.0 - 90.0
    left = math.radians(upright + 90.0)
    note = axes.annotate(
        text,
        tuple(center + 0.55 * (rim - center)),
        rotation=upright,
        rotation_mode="anchor",
        ha="center",
        va="bottom",
        xytext=(2.0 * math.cos(left), 2.0 * math.sin(left)),
        textcoords="offset points",
    )
    return [line, footprint(axes, note)]


def _draw_path(axes: Axes, motion: SingleTurn, capture: float) -> None:
    """Draw the path to the capture; a broken line is the rest of a turn that is cut short."""
    draw(axes, FLOWN, motion.path(capture))
    if capture < motion.turn_end:
        draw(axes, PLANNED, motion.path(motion.turn_end))
    draw(axes, EVADERS, motion.at(0.0))
    draw(axes, DOTS, motion.at(motion.turn_end))
    draw(axes, PREDICTED, motion.at(capture))
    arrow = 0.12 * float(np.ptp(axes.get_xlim()))
    draw_arrow(axes, motion.at(0.0), motion.heading, arrow)
